# Two CMake packages: BulletHybrid, which needs Bullet alone (its component Files needs pugixml and qhull, too), and scatter, which
# needs BulletHybrid; and pkg-config files for the same. The install components Programs, Window and Development become
# packages of their own in ScatterPackage.cmake.
include(CMakePackageConfigHelpers)

# scatter_install_targets(NAME NAMESPACE package TARGETS... HEADERS folder): exports the targets as package::…, in the files of the
# CMake package, and installs include/<folder>.
function(scatter_install_targets name)
  cmake_parse_arguments(ARG "" "HEADERS;NAMESPACE" "TARGETS" ${ARGN})
  install(TARGETS ${ARG_TARGETS} EXPORT ${name}Targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development)
  install(EXPORT ${name}Targets NAMESPACE ${ARG_NAMESPACE}:: COMPONENT Development
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/${ARG_NAMESPACE})
  install(DIRECTORY ${SCATTER_INCLUDE_DIR}/${ARG_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT Development FILES_MATCHING PATTERN "*.h")
endfunction()

# scatter_install_package(NAME): config files with which find_package(NAME) finds the targets wherever the tree is moved to.
function(scatter_install_package name)
  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/${name})
  configure_package_config_file(cmake/${name}Config.cmake.in ${PROJECT_BINARY_DIR}/${name}Config.cmake
                                INSTALL_DESTINATION ${destination})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/${name}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/${name}Config.cmake ${PROJECT_BINARY_DIR}/${name}ConfigVersion.cmake
          DESTINATION ${destination} COMPONENT Development)
endfunction()

# scatter_install_module(NAME DESCRIPTION text LIBS text REQUIRES text): NAME.pc, which finds the tree it lies in.
function(scatter_install_module name)
  cmake_parse_arguments(ARG "" "DESCRIPTION;LIBS;REQUIRES" "" ${ARGN})
  file(RELATIVE_PATH SCATTER_PC_TO_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" SCATTER_PC_TO_PREFIX "${SCATTER_PC_TO_PREFIX}")
  configure_file(cmake/module.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT Development)
endfunction()

get_property(scatter_targets GLOBAL PROPERTY SCATTER_TARGETS)
scatter_install_targets(BulletHybrid NAMESPACE BulletHybrid TARGETS BulletHybrid HEADERS BulletHybrid)
scatter_install_targets(BulletHybridFiles NAMESPACE BulletHybrid TARGETS BulletHybridFiles HEADERS BulletHybridFiles)
scatter_install_targets(scatter NAMESPACE scatter TARGETS ${scatter_targets} HEADERS scatter)
scatter_install_package(BulletHybrid)
scatter_install_package(scatter)

scatter_install_module(BulletHybrid
  DESCRIPTION "Nested collision levels for Bullet that switch safely at run time"
  LIBS "-lBulletHybrid"
  REQUIRES "bullet")
scatter_install_module(BulletHybridFiles
  DESCRIPTION "Level files (COLLADA, glTF) for BulletHybrid"
  LIBS "-lBulletHybridFiles"
  REQUIRES "BulletHybrid = ${PROJECT_VERSION}, pugixml, qhull_r")
# Scenes register themselves, so all of theirs is linked.
scatter_install_module(scatter
  DESCRIPTION "${PROJECT_DESCRIPTION}"
  LIBS "-Wl,--whole-archive,-lscatter_scenes_archive,--no-whole-archive -lscatter_lab -lscatter_recording -lscatter_bullet -lscatter_world -lscatter_meshes -lscatter_io -lscatter_levels -lmeshoptimizer"
  REQUIRES "BulletHybrid = ${PROJECT_VERSION}, pugixml, qhull_r, assimp, libzstd")
scatter_install_module(scatter-meshes
  DESCRIPTION "Meshes of any format for scatter, read by Assimp"
  LIBS "-lscatter_meshes -lmeshoptimizer"
  REQUIRES "scatter = ${PROJECT_VERSION}, assimp")

install(TARGETS scatter RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT Programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models/ DESTINATION ${CMAKE_INSTALL_DATADIR}/scatter/models COMPONENT Programs
        FILES_MATCHING PATTERN "*.dae" PATTERN "README.md")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/scatter/scenes COMPONENT Programs
        FILES_MATCHING PATTERN "*.toml" PATTERN "README.md")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/scatter COMPONENT Programs)
if(SCATTER_HAS_VIEWER)
  install(TARGETS scatter-view RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT Window)
endif()
