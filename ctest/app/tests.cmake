# Tests of the whole program: each test_*.py is a ctest, which starts the program under mpirun as a user would.
add_library(collective_counter MODULE app/preloaded/collective_counter.cpp)
add_library(block_signal MODULE app/preloaded/block_signal.cpp)
add_library(failing_calls MODULE app/preloaded/failing_calls.cpp)
add_library(small_machine MODULE app/preloaded/small_machine.cpp)
target_link_libraries(collective_counter PRIVATE MPI::MPI_CXX idiophone_flags)
target_link_libraries(block_signal PRIVATE MPI::MPI_CXX idiophone_flags)
target_link_libraries(failing_calls PRIVATE MPI::MPI_CXX idiophone_flags)
target_link_libraries(small_machine PRIVATE idiophone_flags)
list(JOIN IDIOPHONE_MPIRUN " " mpirun)

set(IDIOPHONE_APP_ENVIRONMENT
    "${IDIOPHONE_MPI_ENVIRONMENT};PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>;IDIOPHONE_MPIRUN=${mpirun};\
IDIOPHONE_SANITIZE=${IDIOPHONE_SANITIZE};\
COLLECTIVE_COUNTER=$<TARGET_FILE:collective_counter>;BLOCK_SIGNAL=$<TARGET_FILE:block_signal>;FAILING_CALLS=$<TARGET_FILE:failing_calls>;\
SMALL_MACHINE=$<TARGET_FILE:small_machine>;\
IDIOPHONE_BUILD=${PROJECT_BINARY_DIR};IDIOPHONE_WEB_MODULES=${PROJECT_BINARY_DIR}/web;IDIOPHONE_LV2=${PROJECT_BINARY_DIR}/lv2")

function(idiophone_app_test name)
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/app/test_${name}.py)
  add_test(NAME app.${name} COMMAND ${script} -v)
  set_tests_properties(app.${name} PROPERTIES TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT "${IDIOPHONE_APP_ENVIRONMENT}")
  idiophone_has_long_checks(has_long_checks ${script})
  if(has_long_checks)
    add_test(NAME app.${name}_long COMMAND ${script} -v)
    set_tests_properties(app.${name}_long PROPERTIES TIMEOUT 43200 LABELS long
      ENVIRONMENT "${IDIOPHONE_APP_ENVIRONMENT};IDIOPHONE_LONG=1")
  endif()
endfunction()

foreach(name IN ITEMS same_bits listen recorded_body damage stopping output_lock wrong_input collectives outputs listeners
        heard_forces
        physics visibility movie modes modal_bodies map mesh_notes mesh_file meshes_in_parts contact self_contact radiation radiate radiate_joined waves table1 install
        answers explore explorer_page explorer_large made_bodies falling drop detail_over_cost abx report site play strokes proxies rooms stage fitting bench timbre music timbre_faust
        timbre_run midi_out evolve_page gltf measured_map fracture screens diffraction changing_triangles proxy_bodies
        instruction_set packages repaired joints hertz failing_calls scale rescale bowed accelerator phantom_partials timpani guitar_string common_modes)
  idiophone_app_test(${name})
endforeach()
# The longest ones begin first, so that none of them is left at the end.
set_tests_properties(app.same_bits app.fitting app.modal_bodies PROPERTIES COST 90)
# They measure time, so they have two cores for themselves. The others may share them.
set_tests_properties(app.stopping app.play app.proxies app.midi_out app.output_lock PROPERTIES PROCESSORS 2)
set_tests_properties(app.play app.proxies app.midi_out PROPERTIES RESOURCE_LOCK jackd) # a server with one name
if(TARGET idiophone_lv2)
  idiophone_app_test(jalv)
  set_tests_properties(app.jalv PROPERTIES RESOURCE_LOCK jackd)
endif()
# What tests of web pages need of npm. A browser has several processes, so two such tests at once are enough.
add_test(NAME app.web_modules COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/app/web.py)
set_tests_properties(app.web_modules PROPERTIES FIXTURES_SETUP web_modules COST 100 ENVIRONMENT "${IDIOPHONE_APP_ENVIRONMENT}")
set_tests_properties(app.explore app.explorer_page app.made_bodies app.falling app.drop app.abx app.bench app.report app.site app.evolve_page app.gltf app.explorer_large
  PROPERTIES FIXTURES_REQUIRED web_modules PROCESSORS 2 COST 80)

# A short form of tools/torment, always with the same trials.
add_test(NAME app.torment COMMAND ${PROJECT_SOURCE_DIR}/tools/torment --minutes 0.25 --seed 1 --slowness 4
  --program $<TARGET_FILE:idiophone> --keep ${PROJECT_BINARY_DIR}/torment)
set_tests_properties(app.torment PROPERTIES PROCESSORS 2 TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)

# Tests of single classes.
idiophone_test(app LINKS idiophone_petsc_environment)
