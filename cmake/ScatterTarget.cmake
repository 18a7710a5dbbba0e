# Compile options that every target of this project shares.
add_library(scatter_options INTERFACE)
target_compile_features(scatter_options INTERFACE cxx_std_20)
target_compile_options(scatter_options INTERFACE
  # GCC 12 reports false restrict violations in "literal" + std::string at -O3.
  -Wall -Wextra -Wpedantic $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  # The same bits at every optimisation level: no fused multiply-add, no reassociation.
  -ffp-contract=off)
if(SCATTER_WARNINGS_AS_ERRORS)
  target_compile_options(scatter_options INTERFACE -Werror)
endif()
if(SCATTER_SANITIZE)
  target_compile_options(scatter_options INTERFACE -fsanitize=${SCATTER_SANITIZE} -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer
    # GCC 12 reports false ones in instrumented code.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(scatter_options INTERFACE -fsanitize=${SCATTER_SANITIZE})
endif()

set(SCATTER_INCLUDE_DIR ${PROJECT_SOURCE_DIR}/include)

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
endfunction()

# scatter_test(NAME SOURCES... LINK deps... [ENVIRONMENT name=value...]): a GoogleTest program whose cases CTest lists one by one.
function(scatter_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;ENVIRONMENT" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE SCATTER_TEST_MODEL_DIR="${PROJECT_SOURCE_DIR}/models")
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main scatter_options)
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()
