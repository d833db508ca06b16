# Outside packages for a page: headers of the system's own packages, through a folder of links, since /usr/include itself
# holds another C library's; ImGui from its source. tools/web.sh brings both about.

set(links "${CMAKE_CURRENT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${links}")
foreach(entry IN ITEMS glm nlohmann CLI tiny_obj_loader.h)
  file(CREATE_LINK "/usr/include/${entry}" "${links}/${entry}" SYMBOLIC)
endforeach()
alias_headers(knit_glm "${links}")
alias_headers(knit_json "${links}")
alias_headers(knit_cli11 "${links}")
alias_headers(knit_eigen /usr/include/eigen3)
alias_headers(knit_stb /usr/include/stb)

file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/tiny_obj_loader.cpp"
  CONTENT "#define TINYOBJLOADER_IMPLEMENTATION\n#include <tiny_obj_loader.h>\n")
add_library(knit_tinyobjloader STATIC "${CMAKE_CURRENT_BINARY_DIR}/tiny_obj_loader.cpp")
target_include_directories(knit_tinyobjloader SYSTEM PUBLIC "${links}")
# It takes lines character by character, and the ready-made strings of emscripten's library are built small, not fast.
target_compile_definitions(knit_tinyobjloader
  PUBLIC TINYOBJLOADER_USE_DOUBLE PRIVATE _LIBCPP_DISABLE_EXTERN_TEMPLATE)

set(KNIT_IMGUI_SOURCE "" CACHE PATH "The folder of Dear ImGui's source")
if(NOT EXISTS "${KNIT_IMGUI_SOURCE}/imgui.cpp")
  message(FATAL_ERROR "Dear ImGui's source is not in \"${KNIT_IMGUI_SOURCE}\". Build with tools/web.sh, which fetches it.")
endif()
add_library(knit_imgui STATIC
  "${KNIT_IMGUI_SOURCE}/imgui.cpp"
  "${KNIT_IMGUI_SOURCE}/imgui_draw.cpp"
  "${KNIT_IMGUI_SOURCE}/imgui_tables.cpp"
  "${KNIT_IMGUI_SOURCE}/imgui_widgets.cpp"
  "${KNIT_IMGUI_SOURCE}/misc/cpp/imgui_stdlib.cpp")
target_include_directories(knit_imgui SYSTEM PUBLIC "${KNIT_IMGUI_SOURCE}" "${KNIT_IMGUI_SOURCE}/misc/cpp")
target_compile_definitions(knit_imgui PUBLIC IMGUI_DISABLE_DEMO_WINDOWS)
target_compile_options(knit_imgui PRIVATE -Oz)
add_library(knit_imgui_opengl3 STATIC "${KNIT_IMGUI_SOURCE}/backends/imgui_impl_opengl3.cpp")
target_include_directories(knit_imgui_opengl3 SYSTEM PUBLIC "${KNIT_IMGUI_SOURCE}/backends")
target_compile_definitions(knit_imgui_opengl3 PRIVATE IMGUI_IMPL_OPENGL_ES3)
target_link_libraries(knit_imgui_opengl3 PUBLIC knit_imgui)

# The page has these by itself, or does without.
foreach(name IN ITEMS knit_glfw knit_glad knit_egl knit_gif)
  add_library(${name} INTERFACE)
endforeach()
