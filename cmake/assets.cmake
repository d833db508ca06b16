# Fills assets/ in the build folder: generated meshes, the files kept beside them, fonts.

function(copy_font name)
  cmake_parse_arguments(PARSE_ARGV 1 font "" "" "NAMES;SUFFIXES")
  find_file(found NAMES ${font_NAMES}
    PATHS /usr/share/fonts /usr/local/share/fonts "$ENV{HOME}/.local/share/fonts" "$ENV{HOME}/.fonts"
    PATH_SUFFIXES ${font_SUFFIXES} NO_DEFAULT_PATH NO_CACHE)
  if(found)
    configure_file("${found}" "${CMAKE_BINARY_DIR}/assets/fonts/${name}" COPYONLY)
  else()
    message(STATUS "Font ${name} not found; the window uses the next best")
  endif()
endfunction()

function(make_assets)
  set(out "${CMAKE_BINARY_DIR}/assets")
  set(products "")

  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}/assets" "assets/*")
  list(FILTER files INCLUDE REGEX "/")
  list(FILTER files EXCLUDE REGEX "\\.(cpp|h)$")
  foreach(file IN LISTS files)
    add_custom_command(OUTPUT "${out}/${file}"
      COMMAND ${CMAKE_COMMAND} -E copy "${CMAKE_SOURCE_DIR}/assets/${file}" "${out}/${file}"
      DEPENDS "${CMAKE_SOURCE_DIR}/assets/${file}" COMMENT "Copying assets/${file}" VERBATIM)
    list(APPEND products "${out}/${file}")
  endforeach()

  if(TARGET make_examples)
    # The names of the meshes are known to the program alone, hence a stamp.
    set(stamp "${CMAKE_BINARY_DIR}/generated/examples.stamp")
    add_custom_command(OUTPUT "${stamp}"
      COMMAND ${CMAKE_COMMAND} -E make_directory "${out}" "${CMAKE_BINARY_DIR}/generated"
      COMMAND make_examples "${out}"
      COMMAND ${CMAKE_COMMAND} -E touch "${stamp}"
      DEPENDS make_examples COMMENT "Making the example meshes" VERBATIM)
    list(APPEND products "${stamp}")
  endif()

  add_custom_target(assets ALL DEPENDS ${products})
  if(TARGET knit-mesh)
    add_dependencies(knit-mesh assets)
  endif()

  set(inter opentype/inter truetype/inter inter)
  copy_font(Inter-Regular.otf NAMES Inter-Regular.otf Inter-Regular.ttf SUFFIXES ${inter})
  copy_font(Inter-SemiBold.otf NAMES Inter-SemiBold.otf Inter-SemiBold.ttf SUFFIXES ${inter})
  copy_font(Inter-Bold.otf NAMES Inter-Bold.otf Inter-Bold.ttf SUFFIXES ${inter})
  copy_font(JetBrainsMono-Regular.ttf NAMES JetBrainsMono-Regular.ttf
    SUFFIXES truetype/jetbrains-mono jetbrains-mono)
endfunction()
