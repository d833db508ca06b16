# Puts the text of every shader into the program: shaders::source("mesh.vert").

function(embed_shaders target)
  file(GLOB files CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}/shaders"
    "shaders/*.glsl" "shaders/*.vert" "shaders/*.frag" "shaders/*.geom")
  set(SHADER_ENTRIES "")
  foreach(file IN LISTS files)
    set(path "${CMAKE_SOURCE_DIR}/shaders/${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    file(READ "${path}" text)
    string(APPEND SHADER_ENTRIES "    {\"${file}\", R\"__glsl__(${text})__glsl__\"},\n")
  endforeach()
  set(out "${CMAKE_BINARY_DIR}/generated/shaders")
  configure_file(cmake/shaders_embedded.cpp.in "${out}/shaders_embedded.cpp" @ONLY)
  configure_file(cmake/shaders_embedded.h "${out}/shaders_embedded.h" COPYONLY)
  target_sources(${target} PRIVATE "${out}/shaders_embedded.cpp")
  target_include_directories(${target} PUBLIC "${out}")
  # A build for developers reads a shader again when its file is saved.
  target_compile_definitions(${target} PRIVATE
    "$<$<CONFIG:Debug,RelWithDebInfo>:KNIT_SHADER_DIR=\"${CMAKE_SOURCE_DIR}/shaders\">")
endfunction()
