# `cpack -G DEB` in a build folder makes the Debian packages scatter (the program, models and scenes), scatter-view (the window,
# where it was built) and libscatter-dev (headers and libraries).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME scatter)
set(CPACK_PACKAGE_CONTACT "Scatter maintainers <maintainers@users.noreply.example>")
set(CPACK_PACKAGE_VENDOR "Scatter maintainers")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
# Whatever the umask is.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL Programs Development)
if(SCATTER_HAS_VIEWER)
  list(APPEND CPACK_COMPONENTS_ALL Window)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME scatter)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "scatter-view, libscatter-dev")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "The program scatter runs scenes in plain Bullet worlds and in worlds whose
bodies have nested collision levels that switch safely at run time. It counts
and times every stage, draws figures, and makes nested levels from meshes.")

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME scatter-view)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "scatter (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS libgl1-mesa-dri)
set(CPACK_DEBIAN_WINDOW_DESCRIPTION "The window, which the program scatter starts. It shows one world, or two worlds
side by side, with their levels and contacts.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libscatter-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libassimp-dev, libbullet-dev, libexpected-dev, libglm-dev, libmeshoptimizer-dev, libpugixml-dev, libqhull-dev, libzstd-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "scatter (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "BulletHybrid is for programs that use Bullet directly, and needs nothing else;
BulletHybridFiles loads their level files. scatter is the library behind the
program of that name.")

# Debian wants each package's licence in a place of its own.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  install(FILES LICENSE RENAME copyright COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
endforeach()
include(CPack)
