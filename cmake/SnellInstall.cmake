# What "cmake --install" brings: the library with its headers and its package for find_package(snell),
# licence and documents. The program installs itself (apps/cli).
include(CMakePackageConfigHelpers)

option(SNELL_INSTALL "Make the install target" ${PROJECT_IS_TOP_LEVEL})

# snell_install_library(target headers...): the headers are given relative to src and included by users as
# <snell/ROOM/NAME.h>. They include one another relatively, so that they stand alone wherever they lie.
function(snell_install_library target)
  add_library(snell::${target} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    INSTALL_RPATH_USE_LINK_PATH ON)

  # Those who build Snell within their own project see the headers under the same names
  set(include ${PROJECT_BINARY_DIR}/include)
  file(MAKE_DIRECTORY ${include})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src ${include}/snell SYMBOLIC)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${include}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

  if(NOT SNELL_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT snellTargets)
  foreach(header IN LISTS ARGN)
    get_filename_component(room ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/src/${header}
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/snell/${room})
  endforeach()

  # The package: while the major version is 0, a new minor version may break its users
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/snell)
  install(EXPORT snellTargets NAMESPACE snell:: DESTINATION ${package})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SnellConfig.cmake.in
                                ${PROJECT_BINARY_DIR}/snellConfig.cmake INSTALL_DESTINATION ${package})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/snellConfigVersion.cmake
                                   COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/snellConfig.cmake ${PROJECT_BINARY_DIR}/snellConfigVersion.cmake
          DESTINATION ${package})

  # Licence and documents, laid out as in the source tree so that their links hold
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
                ${PROJECT_SOURCE_DIR}/CHANGELOG.md
          DESTINATION ${CMAKE_INSTALL_DOCDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/gallery DESTINATION ${CMAKE_INSTALL_DOCDIR}/scenes)
endfunction()
