# Targets from globs: a new source file needs no line in CMake, and a folder may still be empty.

add_library(our_flags INTERFACE)
target_compile_options(our_flags INTERFACE
  # The same input gives the same bits on every machine: no fused multiply-add.
  -ffp-contract=off
  # A designated initialiser leaves the other members at their defaults on purpose.
  -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers
  $<$<COMPILE_LANGUAGE:CXX>:-Wconversion>
  # In batches a name of one file is seen in the next; clang minds where g++ does not. tools/each_file.py tells true ones.
  $<$<AND:$<BOOL:${KNIT_UNITY}>,$<CXX_COMPILER_ID:Clang>>:-Wno-shadow>
  $<$<BOOL:${KNIT_WARNINGS_AS_ERRORS}>:-Werror>)
target_include_directories(our_flags INTERFACE "${CMAKE_SOURCE_DIR}")

# our_library(name folder...): every .cpp in these folders and the folders in them.
function(our_library name)
  list(TRANSFORM ARGN APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS LIST_DIRECTORIES false ${patterns})
  if(NOT sources)
    set(sources "${CMAKE_BINARY_DIR}/generated/empty.cpp")
    file(CONFIGURE OUTPUT "${sources}" CONTENT "")
  endif()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC "${CMAKE_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE our_flags)
  # The files of a folder at once: a header that all of them include is read once. Names in anonymous namespaces are
  # the folder's then, not the file's.
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${KNIT_UNITY} UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${CMAKE_SOURCE_DIR}")
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
endfunction()

# Headers that most files of a library include, compiled once. Only where asked for: elsewhere each file shows that it
# includes what it needs.
function(precompile name)
  if(KNIT_PRECOMPILE)
    target_precompile_headers(${name} PRIVATE ${ARGN})
  endif()
endfunction()

# Makes no target when there is no source yet.
function(our_program name)
  file(GLOB sources CONFIGURE_DEPENDS LIST_DIRECTORIES false ${ARGN})
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE our_flags)
  if(KNIT_SANITIZE)
    target_sources(${name} PRIVATE "${CMAKE_SOURCE_DIR}/cmake/keep_drivers_loaded.cpp")
    set_target_properties(${name} PROPERTIES ENABLE_EXPORTS ON)
    target_link_options(${name} PRIVATE -rdynamic)
  endif()
endfunction()
