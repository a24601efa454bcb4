# The extension of the Python module: idiophone._core, in the build folder under python/idiophone.
set(IDIOPHONE_PYTHON AUTO CACHE STRING "Build the extension of the Python module: ON, OFF, or AUTO (if pybind11 is found)")
set_property(CACHE IDIOPHONE_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the extension is for") # that of Debian's packages
set(PYBIND11_FINDPYTHON ON)
if(IDIOPHONE_PYTHON AND IDIOPHONE_SANITIZE)
  message(NOTICE "Without the extension of the Python module: a Python without sanitizers can't load it")
elseif(IDIOPHONE_PYTHON STREQUAL AUTO)
  find_package(pybind11 2.10 QUIET)
elseif(IDIOPHONE_PYTHON)
  find_package(pybind11 2.10 REQUIRED)
endif()

if(TARGET pybind11::module)
  pybind11_add_module(idiophone_python MODULE NO_EXTRAS src/python_module.cpp)
  target_link_libraries(idiophone_python PRIVATE idiophone_app idiophone_flags)
  target_link_options(idiophone_python PRIVATE -Wl,--as-needed)
  set_target_properties(idiophone_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/python/idiophone)
  add_dependencies(idiophone_python idiophone idiophone_gmsh)
else()
  message(NOTICE "Without the extension of the Python module (IDIOPHONE_PYTHON is ${IDIOPHONE_PYTHON}): deck.run() can't take an "
                 "MPI communicator, and deck.modes() calls the program")
endif()
