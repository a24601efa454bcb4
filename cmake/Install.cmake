# What `cmake --install` and `cpack` put in place: the program, its man page, the plugin, and in share/idiophone the meshes, decks, accuracy
# ledger, documentation and scripts, which refer to each other by the paths they have here.
# The component `python` is the Python module, and `program` all else (cmake/Packages.cmake).
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)

set(man_page ${PROJECT_BINARY_DIR}/idiophone.1)
# A sanitized program also reports what other libraries leak: here nobody reads that.
add_custom_command(OUTPUT ${man_page}
  COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${PROJECT_SOURCE_DIR}/tools/man_page $<TARGET_FILE:idiophone> ${man_page}
  DEPENDS idiophone ${PROJECT_SOURCE_DIR}/tools/man_page VERBATIM)
add_custom_target(idiophone_man_page ALL DEPENDS ${man_page})

set(share ${CMAKE_INSTALL_DATADIR}/idiophone)
install(TARGETS idiophone)
# For a package that also has programs for newer processors (src/instruction_set.cpp).
install(TARGETS idiophone DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/idiophone/${IDIOPHONE_ARCHITECTURE} COMPONENT newer_processors
        EXCLUDE_FROM_ALL)
install(TARGETS idiophone_gmsh DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/idiophone)
if(TARGET idiophone_lv2) # where hosts look below /usr and below /usr/local
  install(TARGETS idiophone_lv2 idiophone_lv2_code LIBRARY DESTINATION lib/lv2/idiophone.lv2)
  install(FILES src/plugin/bundle/manifest.ttl src/plugin/bundle/idiophone.ttl DESTINATION lib/lv2/idiophone.lv2)
endif()
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY meshes inputs docs verification DESTINATION ${share})
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE DESTINATION ${share})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/idiophone RENAME copyright)
install(PROGRAMS scripts/spectrum scripts/spectrogram scripts/blows_figure scripts/score_figure scripts/sound_map_figure scripts/polar scripts/figure scripts/movie
        scripts/mesh_sequence scripts/gallery scripts/plugin_presets scripts/timbre_examples scripts/mpi_environment DESTINATION ${share}/scripts)
install(FILES scripts/job.slurm DESTINATION ${share}/scripts)
set(library scripts/library)
install(FILES ${library}/__init__.py ${library}/mpi.py ${library}/recording.py ${library}/sound_picture.py ${library}/gallery.py
        ${library}/surface_motion.py
        DESTINATION ${share}/${library})
install(DIRECTORY ${library}/cinema DESTINATION ${share}/${library} PATTERN __pycache__ EXCLUDE)
install(DIRECTORY blender DESTINATION ${share} PATTERN __pycache__ EXCLUDE)

set(modules lib/python3/dist-packages) # where Debian's Python looks
install(DIRECTORY python/idiophone DESTINATION ${modules} COMPONENT python PATTERN __pycache__ EXCLUDE)
if(TARGET idiophone_python)
  install(TARGETS idiophone_python OPTIONAL LIBRARY DESTINATION ${modules}/idiophone COMPONENT python)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-idiophone RENAME copyright COMPONENT python)

# The libraries of proxies, timbre trees and voices for other programs.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Idiophone)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/IdiophoneConfig.cmake.in ${PROJECT_BINARY_DIR}/IdiophoneConfig.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/IdiophoneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/IdiophoneConfig.cmake ${PROJECT_BINARY_DIR}/IdiophoneConfigVersion.cmake
        DESTINATION ${package_folder})
install(TARGETS idiophone_proxies idiophone_deck idiophone_spectra idiophone_nodes idiophone_language
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/idiophone/instruments/proxies DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/instruments)
install(DIRECTORY include/idiophone/timbre/nodes include/idiophone/timbre/language
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/timbre)
install(FILES include/idiophone/foundation/types.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/foundation)
install(FILES include/idiophone/foundation/deck/location.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/foundation/deck)
install(TARGETS idiophone_voices_static idiophone_voices_shared ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES include/idiophone/voices.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone)
install(DIRECTORY include/idiophone/instruments/engines DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/instruments)
install(FILES include/idiophone/instruments/touching/contact_events.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/idiophone/instruments/touching)
install(DIRECTORY LICENSES DESTINATION ${CMAKE_INSTALL_DATADIR}/idiophone)
