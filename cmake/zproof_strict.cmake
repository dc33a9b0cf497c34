# Every flag that can change a result or a warning, in one place.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The rooms are parts of programs and of the Python module. What is hidden is called there as directly as in a program.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
# Asserts stay on in the release build: our own bugs end the run instead of colouring a verdict.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -g1")

add_library(zproof_strict INTERFACE)
target_include_directories(zproof_strict INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/zproof>)
option(ZPROOF_TBB_STAND_IN "loops run on tests/threads/tbb in TBB's stead, whose hand-overs ThreadSanitizer sees" OFF)
if(ZPROOF_TBB_STAND_IN)
    target_include_directories(zproof_strict BEFORE INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/tests/threads>)
endif()
# Warnings are ours alone, not those of a project that has us as a subfolder; the floating-point rules also hold for
# whoever compiles our headers.
if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(zproof_strict INTERFACE
        $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wnon-virtual-dtor;-Wold-style-cast>
        $<BUILD_INTERFACE:-Woverloaded-virtual;-Werror>
        # Where no branch is wanted, `&` joins conditions (compare/bounds). Of signs g++'s -Wconversion asks nothing in C++.
        $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical;-Wno-sign-conversion>>)
endif()
target_compile_options(zproof_strict INTERFACE
    -ffp-contract=off -fno-fast-math
    # g++ 12 drops the rounding of two neighbouring floats that become doubles (tests/math/compiler_test.cpp).
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
    # g++ 12 sees an overlapping copy in "literal" + std::string&& (GCC bug 105329, a false alarm, mended in 13).
    # Where headers are precompiled, it says the same of the standard library's arrays: false alarms of that library's code.
    $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>>)
target_compile_definitions(zproof_strict INTERFACE GLM_FORCE_EXPLICIT_CTOR)
target_compile_features(zproof_strict INTERFACE cxx_std_20)
