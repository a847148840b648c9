include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(raio_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/raio)

install(TARGETS raio EXPORT raio-targets FILE_SET HEADERS)
install(EXPORT raio-targets NAMESPACE raio:: DESTINATION ${raio_package_dir})

configure_package_config_file(cmake/raio-config.cmake.in raio-config.cmake INSTALL_DESTINATION ${raio_package_dir})
write_basic_package_version_file(raio-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/raio-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/raio-config-version.cmake
    DESTINATION ${raio_package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
