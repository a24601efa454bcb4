idiophone_test(solids/modal_bodies)

add_test(NAME modal_bodies.ten_seconds_long COMMAND test_modal_bodies
  --gtest_filter=StretchingForce.ConservesTheEnergyForTenSeconds)
set_tests_properties(modal_bodies.ten_seconds_long PROPERTIES LABELS long TIMEOUT 600 ENVIRONMENT IDIOPHONE_TEN_SECONDS=1)
