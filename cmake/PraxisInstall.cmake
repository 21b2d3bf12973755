# cmake --install and find_package(praxis): the command, the libraries and their headers.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/praxis)
set_target_properties(praxis_parser PROPERTIES EXPORT_NAME parser)
set_target_properties(praxis_search PROPERTIES EXPORT_NAME search)
set_target_properties(praxis_belief PROPERTIES EXPORT_NAME belief)
set_target_properties(praxis_practice PROPERTIES EXPORT_NAME practice)
foreach(target praxis_parser praxis_search praxis_belief praxis_practice)
  target_include_directories(${target} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/praxis>)
  target_compile_features(${target} PUBLIC cxx_std_20)
endforeach()

install(TARGETS plan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS praxis_parser praxis_search praxis_belief praxis_practice EXPORT praxis-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/parser ${PROJECT_SOURCE_DIR}/search ${PROJECT_SOURCE_DIR}/belief ${PROJECT_SOURCE_DIR}/practice
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/praxis
        FILES_MATCHING PATTERN "*.hpp" PATTERN "belief/perception" EXCLUDE)
install(EXPORT praxis-targets NAMESPACE praxis:: DESTINATION ${config_dir})
if(PRAXIS_BUILD_TAMP)
  set_target_properties(praxis_tamp PROPERTIES EXPORT_NAME tamp)
  target_include_directories(praxis_tamp PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/praxis>)
  target_compile_features(praxis_tamp PUBLIC cxx_std_20)
  install(TARGETS plan-refine RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS praxis_tamp EXPORT praxis-tamp-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/tamp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/praxis
          FILES_MATCHING PATTERN "*.hpp" PATTERN "tamp/*/web" EXCLUDE)
  install(EXPORT praxis-tamp-targets NAMESPACE praxis:: DESTINATION ${config_dir})
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/praxis-config.cmake.in
                              ${PROJECT_BINARY_DIR}/praxis-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/praxis-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/praxis-config.cmake ${PROJECT_BINARY_DIR}/praxis-config-version.cmake
        DESTINATION ${config_dir})
