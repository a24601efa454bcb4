# The accuracy ledger: every day its own arithmetic and the small cases, and on demand (ctest --preset verification) all.
add_test(NAME verification.ledger COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/verification/test_ledger.py -v)
set_tests_properties(verification.ledger PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
add_test(NAME verification.short
         COMMAND ${PROJECT_SOURCE_DIR}/tools/verify --short --ranks 1 --program $<TARGET_FILE:idiophone>
                 --results ${PROJECT_BINARY_DIR}/verification_short)
set_tests_properties(verification.short PROPERTIES COST 90 TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
add_test(NAME verification.long COMMAND ${PROJECT_SOURCE_DIR}/tools/verify --program $<TARGET_FILE:idiophone>)
set_tests_properties(verification.long PROPERTIES PROCESSORS 2 TIMEOUT 10800 LABELS long)
