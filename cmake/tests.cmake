# ctest knows every test case of tests/*_test.cpp and every script tests/*_test.sh.

# While one works on a part: cmake --preset dev -DKNIT_TEST_FILES="tests/lesson*_test.cpp"
set(KNIT_TEST_FILES "tests/*_test.cpp" CACHE STRING "Which test files to build, as a pattern")
our_program(knit_tests ${KNIT_TEST_FILES} "tests/support/*.cpp")
if(TARGET knit_tests)
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
    file(GLOB files CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}" ${KNIT_TEST_FILES})
    foreach(file IN LISTS files)
      get_filename_component(name "${file}" NAME_WE)
      add_test(NAME "${name}" COMMAND knit_tests ${KNIT_CATCH2_ARGUMENTS} --filenames-as-tags "[#${name}]~[.]")
      set_tests_properties("${name}" PROPERTIES TIMEOUT 1500)
    endforeach()
  else()
    include(Catch)
    catch_discover_tests(knit_tests EXTRA_ARGS ${KNIT_CATCH2_ARGUMENTS} PROPERTIES TIMEOUT 300)
  endif()
endif()

file(GLOB scripts CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}" "tests/*_test.sh")
foreach(script IN LISTS scripts)
  get_filename_component(name "${script}" NAME)
  add_test(NAME "${name}" COMMAND bash "${CMAKE_SOURCE_DIR}/${script}")
  set_tests_properties("${name}" PROPERTIES TIMEOUT 300
    RESOURCE_LOCK display  # they press keys and watch the clock, so one at a time
    ENVIRONMENT "KNIT_MESH=${CMAKE_BINARY_DIR}/knit-mesh;KNIT_SOURCE_DIR=${CMAKE_SOURCE_DIR}")
endforeach()
