include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(raio_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/raio)

install(TARGETS raio EXPORT raio-targets FILE_SET HEADERS)
install(FILES include/raio/raio.cppm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/raio)
install(EXPORT raio-targets NAMESPACE raio:: DESTINATION ${raio_package_dir})

configure_package_config_file(cmake/raio-config.cmake.in raio-config.cmake
    INSTALL_DESTINATION ${raio_package_dir} PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(raio-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
    cmake/raio-module.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/raio-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/raio-config-version.cmake
    DESTINATION ${raio_package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
