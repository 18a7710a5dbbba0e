# scatter_report_page(SOURCE): makes SOURCE, which holds the report's page, bundled by esbuild; empty in a build without the page.
set(SCATTER_REPORT_PAGE_DIR ${CMAKE_CURRENT_LIST_DIR})
function(scatter_report_page source)
  set(here ${SCATTER_REPORT_PAGE_DIR})
  if(SCATTER_REPORT_PAGE STREQUAL "OFF")
    # There from the start, for what reads sources and builds nothing.
    file(COPY_FILE ${here}/no_page_bundle.cpp ${source} ONLY_IF_DIFFERENT)
    return()
  endif()
  file(GLOB parts CONFIGURE_DEPENDS ${here}/src/* ${here}/licences/*)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${here} -DFOLDER=${PROJECT_BINARY_DIR}/report_page -DBUNDLE=${source}
            -DWANTED=${SCATTER_REPORT_PAGE} -DHAS_NPM=${SCATTER_HAS_REPORT_PAGE} -DNPM=${SCATTER_NPM} -DNODE=${SCATTER_NODE}
            -P ${here}/bundle.cmake
    DEPENDS ${parts} ${here}/bundle.cmake ${here}/bundle.mjs ${here}/no_page_bundle.cpp ${here}/package.json ${here}/package-lock.json
    COMMENT "Bundling the report's page" VERBATIM)
endfunction()
