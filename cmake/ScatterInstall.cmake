# Two packages: BulletHybrid, which needs Bullet alone, and scatter, which needs BulletHybrid.
include(CMakePackageConfigHelpers)

# scatter_install_package(NAME TARGETS... [HEADERS folder]): exports the targets as NAME::…, with a config file that
# find_package(NAME) finds wherever the tree is moved to.
function(scatter_install_package name)
  cmake_parse_arguments(ARG "" "HEADERS" "TARGETS" ${ARGN})
  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/${name})
  install(TARGETS ${ARG_TARGETS} EXPORT ${name}Targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT ${name}Targets NAMESPACE ${name}:: DESTINATION ${destination})
  install(DIRECTORY ${SCATTER_INCLUDE_DIR}/${ARG_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h")
  configure_package_config_file(cmake/${name}Config.cmake.in ${PROJECT_BINARY_DIR}/${name}Config.cmake
                                INSTALL_DESTINATION ${destination})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/${name}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/${name}Config.cmake ${PROJECT_BINARY_DIR}/${name}ConfigVersion.cmake
          DESTINATION ${destination})
endfunction()

get_property(scatter_targets GLOBAL PROPERTY SCATTER_TARGETS)
scatter_install_package(BulletHybrid TARGETS BulletHybrid HEADERS BulletHybrid)
scatter_install_package(scatter TARGETS ${scatter_targets} HEADERS scatter)
install(TARGETS scatter RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(SCATTER_HAS_VIEWER)
  install(TARGETS scatter-view RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/scatter)
