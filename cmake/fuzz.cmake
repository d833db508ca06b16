# The fuzz targets of tests/fuzz, with libFuzzer and the sanitizers: docs/testing.md says how to run them.
# Every fuzz_<name>.cpp there is a program of its own.

function(fuzz_programs)
  file(GLOB sources CONFIGURE_DEPENDS LIST_DIRECTORIES false "tests/fuzz/fuzz_*.cpp")
  foreach(source IN LISTS sources)
    get_filename_component(name "${source}" NAME_WE)
    add_executable(${name} "${source}")
    # The algorithm alone builds much faster.
    file(STRINGS "${source}" of_the_app REGEX "^#include \"app/")
    target_link_libraries(${name} PRIVATE our_flags knit $<$<BOOL:${of_the_app}>:app_core>)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  endforeach()
endfunction()
