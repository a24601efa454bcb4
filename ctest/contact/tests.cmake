idiophone_test(contact LINKS idiophone_test_support)
target_include_directories(test_contact PRIVATE ${PROJECT_SOURCE_DIR}/src/contact)
