# Configures and builds the project SOURCE in FOLDER against the tree installed in PREFIX, runs it with ARGUMENT and compares what
# it prints with the regular expression EXPECTED.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER} -G Ninja -D CMAKE_PREFIX_PATH=${PREFIX}
                        -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FOLDER}/consumer ${ARGUMENT} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "^${EXPECTED}\n$")
  message(FATAL_ERROR "The program printed\n${output}instead of something that matches\n${EXPECTED}")
endif()
