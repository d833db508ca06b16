# ctest knows every test case of tests/*_test.cpp (under the sanitizers every such file) and every
# script tests/*_test.sh.

# While one works on a part: cmake --preset dev -DKNIT_TEST_FILES="tests/lesson*_test.cpp"
set(KNIT_TEST_FILES "tests/*_test.cpp" CACHE STRING "Which test files to build, as a pattern")
file(GLOB test_files CONFIGURE_DEPENDS LIST_DIRECTORIES false RELATIVE "${CMAKE_SOURCE_DIR}" ${KNIT_TEST_FILES})

# join_files(out files...): names in `out` of what to compile instead, KNIT_JOIN_TESTS files at once.
function(join_files out)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(script "${CMAKE_SOURCE_DIR}/cmake/join_files.py")
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/joined")
  set(result "")
  set(rest "")
  foreach(file IN LISTS ARGN)
    file(STRINGS "${file}" macros REGEX "^#define" LIMIT_COUNT 1)
    if(macros)
      list(APPEND result "${file}")  # they would be its neighbours' too
    else()
      list(APPEND rest "${CMAKE_SOURCE_DIR}/${file}")
    endif()
  endforeach()
  set(number 0)
  while(rest)
    list(SUBLIST rest 0 ${KNIT_JOIN_TESTS} batch)
    list(REMOVE_ITEM rest ${batch})
    math(EXPR number "${number} + 1")
    set(joined "${CMAKE_BINARY_DIR}/joined/tests_${number}.cpp")
    add_custom_command(OUTPUT "${joined}" COMMAND Python3::Interpreter "${script}" "${joined}" ${batch}
      DEPENDS "${script}" ${batch} COMMENT "Joining tests, batch ${number}" VERBATIM)
    list(APPEND result "${joined}")
  endwhile()
  set(${out} "${result}" PARENT_SCOPE)
endfunction()

our_program(knit_tests "tests/support/*.cpp")
if(TARGET knit_tests)
  set(compiled_files ${test_files})
  if(KNIT_JOIN_TESTS GREATER 1)
    join_files(compiled_files ${test_files})
  endif()
  target_sources(knit_tests PRIVATE ${compiled_files})
  target_link_libraries(knit_tests PRIVATE app_window knit_catch2_main knit_stb)
  target_compile_definitions(knit_tests PRIVATE
    "KNIT_MESH_BINARY=\"${CMAKE_BINARY_DIR}/knit-mesh\""
    "KNIT_ASSETS_DIR=\"${CMAKE_BINARY_DIR}/assets\""
    "KNIT_SOURCE_DIR=\"${CMAKE_SOURCE_DIR}\""
    # Meshes that may lie beside a checkout; a test says so and passes where they do not.
    "KNIT_SHARED_MESHES=\"${CMAKE_SOURCE_DIR}/../shared/meshes\"")
  # Stands in for a driver that loses its window; loaded before the program, so without sanitizers.
  add_library(losing_driver MODULE tests/driver/losing_driver.cpp)
  target_compile_options(losing_driver PRIVATE -fno-sanitize=all)
  target_link_options(losing_driver PRIVATE -fno-sanitize=all)
  target_compile_definitions(knit_tests PRIVATE "KNIT_LOSING_DRIVER=\"$<TARGET_FILE:losing_driver>\"")
  # Compiling the tests costs more than running them: what most of them include once, no optimiser, and no counters
  # for the fuzz targets, which do not contain them.
  target_precompile_headers(knit_tests PRIVATE tests/support/catch.h app/session/action.h app/session/document.h
    app/session/view.h)
  target_compile_options(knit_tests PRIVATE -O0 -g1 $<$<BOOL:${KNIT_FUZZ}>:-fno-sanitize=fuzzer-no-link>)
  add_dependencies(knit_tests assets knit-mesh losing_driver)
  if(KNIT_SANITIZE)
    # A file's cases in one process: with the sanitizers each takes half a second to begin.
    foreach(file IN LISTS test_files)
      get_filename_component(name "${file}" NAME_WE)
      # Who is told to end says which case it was at; whom ctest kills says nothing.
      add_test(NAME "${name}" COMMAND timeout 1400 "$<TARGET_FILE:knit_tests>" ${KNIT_CATCH2_ARGUMENTS}
        --filenames-as-tags "[#${name}]~[.]")
      set_tests_properties("${name}" PROPERTIES TIMEOUT 1500)
    endforeach()
    if(TEST monkey_test)
      set_tests_properties(monkey_test PROPERTIES COST 1000)  # the longest begins first
    endif()
  else()
    include(Catch)
    catch_discover_tests(knit_tests EXTRA_ARGS ${KNIT_CATCH2_ARGUMENTS} PROPERTIES TIMEOUT 300)
  endif()
endif()

file(GLOB scripts CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}" "tests/*_test.sh")
foreach(script IN LISTS scripts)
  get_filename_component(name "${script}" NAME)
  if(KNIT_SANITIZE AND name STREQUAL "ledger_test.sh")
    continue()  # runs nothing that was built
  endif()
  add_test(NAME "${name}" COMMAND bash "${CMAKE_SOURCE_DIR}/${script}")
  set_tests_properties("${name}" PROPERTIES TIMEOUT 300
    RESOURCE_LOCK display  # they press keys and watch the clock, so one at a time
    ENVIRONMENT "KNIT_MESH=${CMAKE_BINARY_DIR}/knit-mesh;KNIT_SOURCE_DIR=${CMAKE_SOURCE_DIR}")
endforeach()
