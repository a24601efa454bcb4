# Two Debian packages of one build: cpack -G DEB. dpkg-shlibdeps finds the packages of the libraries. tools/package adds the program
# for newer processors, of a second build, to the first package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Idiophone maintainers <maintainers@idiophone.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENTS_ALL program python)
set(CPACK_COMPONENTS_NEWER_PROCESSORS newer_processors)
set(CPACK_COMPONENT_PROGRAM_GROUP program)
set(CPACK_COMPONENT_NEWER_PROCESSORS_GROUP program)
set(CPACK_COMPONENT_PYTHON_GROUP python)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME idiophone)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION sound)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS openmpi-bin)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-idiophone, python3-matplotlib")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-vtk9, python3-meshio, ffmpeg, xvfb, paraview")

# It reads what the program of its own version answers.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-idiophone)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "idiophone (= ${PROJECT_VERSION}), python3, python3-h5py, python3-numpy, python3-scipy, python3-yaml")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-meshio, python3-mpi4py")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Idiophone in Python: decks, runs, modes, sound maps and results as NumPy arrays")
include(CPack)
