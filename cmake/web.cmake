# The program as a page. The same targets, with the files of app/web in place of those that need a system's window, its
# threads and its folders.

set(KNIT_WEB_ASSETS "" CACHE PATH "assets/ of a native build: meshes made here would differ in their last bits")

function(without target)
  get_target_property(sources ${target} SOURCES)
  foreach(file IN LISTS ARGN)
    list(REMOVE_ITEM sources "${CMAKE_SOURCE_DIR}/${file}")
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
endfunction()

function(make_page)
  without(app_core app/base/beside.cpp app/base/outside.cpp)
  without(app_render app/render/headless_gl.cpp)
  without(app_window app/window/window.cpp app/window/keys.cpp app/window/loop.cpp)
  # What a class fetches counts more than the panels' speed.
  foreach(target IN ITEMS app_core app_panels app_render app_window)
    target_compile_options(${target} PRIVATE -Oz)
  endforeach()
  file(GLOB files CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/app/web/*.cpp")
  target_sources(knit-mesh PRIVATE ${files})
  target_link_libraries(knit-mesh PRIVATE app_window)
  target_link_options(knit-mesh PRIVATE -Oz
    -sMAX_WEBGL_VERSION=2 -sMIN_WEBGL_VERSION=2 -sFULL_ES3 -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=64MB
    -sENVIRONMENT=web -sFORCE_FILESYSTEM -lidbfs.js -sEXIT_RUNTIME=0
    "-sEXPORTED_FUNCTIONS=_main,_malloc,_free"
    "-sEXPORTED_RUNTIME_METHODS=FS,HEAPF32"
    "--preload-file" "${KNIT_WEB_ASSETS}@/assets")
  # For Node, with the files of this machine.
  target_sources(bits PRIVATE app/web/beside_web.cpp app/base/outside.cpp)
  target_link_options(bits PRIVATE -sENVIRONMENT=node -sNODERAWFS -sALLOW_MEMORY_GROWTH)
  foreach(file IN ITEMS page.html page.js)
    configure_file("app/web/${file}" "${CMAKE_BINARY_DIR}/${file}" COPYONLY)
  endforeach()
endfunction()
