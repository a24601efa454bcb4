idiophone_test(parallel RANKS 1 2 3 4 LINKS idiophone_deck idiophone_petsc_environment)
# GCC 12 warns of ArchiveNames read as a MemoryArchive if it inlines this file with others.
set_source_files_properties(parallel/archive_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
