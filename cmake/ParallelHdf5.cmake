# The target hdf5::hdf5: a parallel HDF5 of the same MPI.
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 1.10.8 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "The HDF5 in ${HDF5_C_INCLUDE_DIRS} is not parallel. Install a parallel one, and name its compiler "
                      "wrapper by -DHDF5_C_COMPILER_EXECUTABLE=.../h5pcc")
endif()

# What a shared library says of itself in lines with KEY: its own name (SONAME), or those that it needs (NEEDED).
function(idiophone_dynamic_names file key result)
  execute_process(COMMAND ${CMAKE_READELF} -d ${file} OUTPUT_VARIABLE section ERROR_QUIET)
  string(REGEX MATCHALL "\\(${key}\\)[^\n]*" lines "${section}")
  string(REGEX REPLACE "[^;]*\\[([^;]*)\\]" "\\1" names "${lines}")
  set(${result} ${names} PARENT_SCOPE)
endfunction()

# A program with the HDF5 of another MPI links, and crashes when it opens its first file.
get_target_property(hdf5_library hdf5::hdf5 IMPORTED_LOCATION)
idiophone_dynamic_names(${hdf5_library} NEEDED hdf5_mpi)
list(FILTER hdf5_mpi INCLUDE REGEX mpi)
set(mpi_names "")
foreach(library IN LISTS MPI_CXX_LIBRARIES)
  idiophone_dynamic_names(${library} SONAME name)
  list(APPEND mpi_names ${name})
endforeach()
list(REMOVE_ITEM hdf5_mpi ${mpi_names})
if(hdf5_mpi AND mpi_names)
  message(FATAL_ERROR "${hdf5_library} needs ${hdf5_mpi}, but the MPI found is ${mpi_names}. Name the wrapper of this MPI's "
                      "HDF5 by -DHDF5_C_COMPILER_EXECUTABLE=.../h5pcc, or of the other MPI by -DMPI_CXX_COMPILER=.../mpicxx")
endif()
