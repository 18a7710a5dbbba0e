# Compiles SOURCE, of C++ STANDARD, into FOLDER/consumer with what pkg-config says of MODULES (separated by spaces) in the tree
# installed in PREFIX, runs it and compares what it prints with the regular expression EXPECTED.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
separate_arguments(modules UNIX_COMMAND "${MODULES}")
execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${modules} OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} -std=c++${STANDARD} ${SOURCE} -o ${FOLDER}/consumer ${flags} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${FOLDER}/consumer ${ARGUMENT} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output MATCHES "^${EXPECTED}\n$")
  message(FATAL_ERROR "The program printed\n${output}instead of something that matches\n${EXPECTED}")
endif()
