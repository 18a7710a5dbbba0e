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
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "lab for collision overload in physics simulations
The program runs scenes in plain Bullet worlds and in worlds whose bodies have nested collision levels that switch safely at run
time. It counts and times every stage, draws figures, and makes nested levels from meshes.")

set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME scatter-view)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "scatter (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_WINDOW_DESCRIPTION "window of scatter, a lab for collision overload
The command \"scatter view\" starts it: it shows one world, or two side by side, with their levels and contacts.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libscatter-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libassimp-dev, libbullet-dev, libexpected-dev, libglm-dev, libpugixml-dev, libqhull-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "scatter (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "nested collision levels for Bullet that switch safely at run time
BulletHybrid is for programs that use Bullet directly, and needs nothing else; BulletHybridFiles loads their level files. scatter is
the library behind the program scatter.")

# Debian wants each package's licence in a place of its own.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  install(FILES LICENSE RENAME copyright COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
endforeach()
include(CPack)
