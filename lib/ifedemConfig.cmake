# find_package(ifedem): target ifedem::ifedem, all of the library; #include "step/step.hpp" and so on.
include(CMakeFindDependencyMacro)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(GSL)
find_dependency(fmt 9)
include(${CMAKE_CURRENT_LIST_DIR}/ifedemTargets.cmake)
