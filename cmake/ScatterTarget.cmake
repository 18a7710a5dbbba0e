option(SCATTER_UNITY_BUILD
  "Compile sources in batches and with precompiled headers; OFF compiles each alone, as editors and checks of includes want it" ON)
set(SCATTER_BATCH 30 CACHE STRING "How many sources a batch has at most")

# Compile options that every target of this project shares.
add_library(scatter_options INTERFACE)
target_compile_features(scatter_options INTERFACE cxx_std_20)
target_compile_options(scatter_options INTERFACE
  # GCC 12 reports false restrict violations in "literal" + std::string at -O3, and false uninitialised members of variants.
  -Wall -Wextra -Wpedantic $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-maybe-uninitialized> -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # The same bits at every optimisation level: no fused multiply-add, no reassociation.
  -ffp-contract=off)
if(SCATTER_UNITY_BUILD)
  # GCC 12 reports false ones in "literal" + std::string, when it sees more of the code.
  target_compile_options(scatter_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-array-bounds>)
endif()
if(SCATTER_WARNINGS_AS_ERRORS)
  target_compile_options(scatter_options INTERFACE -Werror)
endif()
if(SCATTER_SANITIZE)
  target_compile_options(scatter_options INTERFACE -fsanitize=${SCATTER_SANITIZE} -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer
    # These four take a third to two fifths of the time of a sanitized build, of readers of files two thirds, half of it the first
    # one. A null pointer, an address beyond an object or one that has wrapped around is found by the address sanitizer, too, once it is used.
    -fno-sanitize=null,object-size,pointer-overflow
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SCATTER_CHECKS_ALIGNMENT>>>:-fno-sanitize=alignment>)
  target_link_options(scatter_options INTERFACE -fsanitize=${SCATTER_SANITIZE})
endif()

# scatter_optimise_lightly(TARGET...): for code that does not run in every step, or waits for a disk: it is compiled in two thirds of
# the time, in a sanitized build too, where addresses are checked by calls: that is slow where much is read, as in readers of files.
function(scatter_optimise_lightly)
  set(option $<$<CONFIG:Release>:-O1>)
  if(SCATTER_SANITIZE)
    set(option $<$<NOT:$<BOOL:$<TARGET_PROPERTY:SCATTER_CHECKS_ALIGNMENT>>>:SHELL:--param$<SEMICOLON>asan-instrumentation-with-call-threshold=0>)
  endif()
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE ${option})
  endforeach()
endfunction()

# scatter_sanitize_lightly(TARGET...): for libraries that tests run for minutes: in a sanitized build they are not checked for locals
# that are used after their block. GLM's many temporaries make that check cost more than all others together: without it, a test that
# builds levels takes 13 s instead of 33 s. They are optimised; the presets have the rest compiled with what optimisation costs no
# time, which saves a quarter of compiling it.
function(scatter_sanitize_lightly)
  if(NOT SCATTER_SANITIZE)
    return()
  endif()
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE -O1 -fno-sanitize-address-use-after-scope)
  endforeach()
endfunction()

# scatter_check_alignment(TARGET...): in a sanitized build with checks of the alignment of addresses: for readers of files.
function(scatter_check_alignment)
  set_target_properties(${ARGN} PROPERTIES SCATTER_CHECKS_ALIGNMENT ON)
endfunction()

set(SCATTER_INCLUDE_DIR ${PROJECT_SOURCE_DIR}/include)

# scatter_compile_in_batches(TARGET [MOST number] [HEADERS target]): its sources are compiled together, so many at most (1: each
# alone), and with the headers that the other target has precompiled.
function(scatter_compile_in_batches target)
  cmake_parse_arguments(ARG "" "MOST;HEADERS" "" ${ARGN})
  if(NOT SCATTER_UNITY_BUILD)
    return()
  endif()
  if(NOT ARG_MOST)
    set(ARG_MOST ${SCATTER_BATCH})
  endif()
  if(ARG_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${ARG_HEADERS})
  endif()
  if(ARG_MOST EQUAL 1)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP
    UNITY_BUILD_CODE_BEFORE_INCLUDE "// NOLINTNEXTLINE(bugprone-suspicious-include)")
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(LENGTH sources count)
  math(EXPR batches "(${count} + ${ARG_MOST} - 1) / ${ARG_MOST}")
  set(index 0)
  foreach(source IN LISTS sources)
    math(EXPR batch "${index} * ${batches} / ${count}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP batch_${batch})
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()

# scatter_precompile(TARGET HEADERS... [LINK deps...] [LIBRARIES]): headers that other targets' batches are compiled with;
# with LIBRARIES for targets with position-independent code.
function(scatter_precompile target)
  cmake_parse_arguments(ARG "LIBRARIES" "" "HEADERS;LINK" ${ARGN})
  if(NOT SCATTER_UNITY_BUILD)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/${target}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Holds nothing: its precompiled headers are used elsewhere.\n")
  add_library(${target} OBJECT ${source})
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ${ARG_LIBRARIES})
  target_link_libraries(${target} PRIVATE ${ARG_LINK} scatter_options)
  target_precompile_headers(${target} PRIVATE ${ARG_HEADERS})
  if(ARG_LIBRARIES AND SCATTER_SANITIZE)
    # As libraries that tests run for minutes: what is optimised otherwise is not inlined into them.
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# scatter_library(NAME SOURCES... [PUBLIC deps...] [PRIVATE deps...]): the static library scatter_NAME,
# alias scatter::NAME, installed and exported.
function(scatter_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(scatter_${name} STATIC ${ARG_SOURCES})
  add_library(scatter::${name} ALIAS scatter_${name})
  set_target_properties(scatter_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(scatter_${name} PUBLIC cxx_std_20)
  target_include_directories(scatter_${name}
    PUBLIC $<BUILD_INTERFACE:${SCATTER_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(scatter_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:scatter_options>)
  set_property(GLOBAL APPEND PROPERTY SCATTER_TARGETS scatter_${name})
  scatter_compile_in_batches(scatter_${name} HEADERS scatter_headers)
endfunction()

# How tests are compiled: with what optimisation costs no time. Not with none: of an inline function that is called in a library, too,
# the linker takes what was compiled here. As the libraries that they run for minutes, they are sanitized lightly.
set(SCATTER_TEST_OPTIONS -Og)
if(SCATTER_SANITIZE)
  list(APPEND SCATTER_TEST_OPTIONS -fno-sanitize-address-use-after-scope)
endif()

# scatter_test(NAME SOURCES... LINK deps... [ENVIRONMENT name=value...] [SHARDS number] [COST seconds] [MOST number]): a GoogleTest
# program. CTest lists its cases one by one, with the label "case", and, in the configuration "shards", as so many processes that
# run all of them. COST: about how long a shard takes in the optimised build, if that is long: CTest starts the longest first, so
# that no core waits for them at the end. MOST: how many sources are compiled together, fewer where their names clash; 1: each alone.
function(scatter_test name)
  cmake_parse_arguments(ARG "" "SHARDS;COST;MOST" "SOURCES;LINK;ENVIRONMENT" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE SCATTER_TEST_MODEL_DIR="${PROJECT_SOURCE_DIR}/models")
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main scatter_options)
  if(NOT ARG_MOST)
    set(ARG_MOST 24)
  endif()
  scatter_compile_in_batches(${name} MOST ${ARG_MOST} HEADERS scatter_test_headers)
  target_compile_options(${name} PRIVATE ${SCATTER_TEST_OPTIONS})
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 600 LABELS case ENVIRONMENT "${ARG_ENVIRONMENT}")
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 2)
  endif()
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  math(EXPR last "${ARG_SHARDS} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}.${shard} CONFIGURATIONS shards COMMAND ${name})
    set_tests_properties(${name}.${shard} PROPERTIES TIMEOUT 1800 LABELS shard COST ${ARG_COST}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${shard};${ARG_ENVIRONMENT}")
  endforeach()
endfunction()
