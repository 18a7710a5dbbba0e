# Writes BUNDLE, the report's page as a C++ source: with WANTED=AUTO an empty one, and a line that says so, where npm or its registry
# cannot be had. Packages go to FOLDER, and are fetched anew only when the list of them changes.

function(give_up why)
  if(WANTED STREQUAL ON)
    message(FATAL_ERROR "The report's page could not be built: ${why}; what was said is in ${FOLDER}/bundle.log")
  endif()
  message("scatter: reports will have no 3D and no plots to zoom into, as ${why}; see ${FOLDER}/bundle.log, and remove ${BUNDLE} to try again")
  file(COPY_FILE ${SOURCE}/no_page_bundle.cpp ${BUNDLE})
endfunction()

file(MAKE_DIRECTORY ${FOLDER})
if(NOT HAS_NPM)
  file(WRITE ${FOLDER}/bundle.log "npm was not looked for, or not found: install nodejs and npm\n")
  give_up("nodejs or npm is missing")
  return()
endif()

# npm would fetch them anew each time.
set(stamp ${FOLDER}/installed.sha256)
file(SHA256 ${SOURCE}/package-lock.json wanted)
set(present "")
if(EXISTS ${stamp})
  file(READ ${stamp} present)
endif()
if(NOT wanted STREQUAL present)
  file(REMOVE ${stamp})
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${FOLDER})
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 --fetch-timeout=30000
                  WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE status OUTPUT_FILE ${FOLDER}/bundle.log ERROR_FILE ${FOLDER}/bundle.log)
  if(NOT status EQUAL 0)
    give_up("npm could not get its packages")
    return()
  endif()
  file(WRITE ${stamp} ${wanted})
endif()

execute_process(COMMAND ${NODE} ${SOURCE}/bundle.mjs ${FOLDER}/node_modules ${BUNDLE}
                RESULT_VARIABLE status OUTPUT_FILE ${FOLDER}/bundle.log ERROR_FILE ${FOLDER}/bundle.log)
if(NOT status EQUAL 0)
  give_up("esbuild failed")
endif()
