idiophone_test(foundation/parallel LINKS idiophone_deck idiophone_petsc_environment)
# GCC 12 warns of ArchiveNames read as a MemoryArchive if it inlines this file with others.
set_source_files_properties(foundation/parallel/archive_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
