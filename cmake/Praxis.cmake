# What every target of the project shares: language level, warnings, sanitizers, ccache, output folders.
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

find_program(PRAXIS_CCACHE ccache)
if(PRAXIS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PRAXIS_CCACHE})
endif()

add_library(praxis_options INTERFACE)
target_compile_options(praxis_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(PRAXIS_WERROR)
  target_compile_options(praxis_options INTERFACE -Werror)
endif()
if(PRAXIS_SANITIZE)
  target_compile_options(praxis_options INTERFACE -fsanitize=${PRAXIS_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(praxis_options INTERFACE -fsanitize=${PRAXIS_SANITIZE})
endif()

# praxis_objects(NAME SOURCES...): the object files of one folder, compiled with the project's options.
function(praxis_objects name)
  add_library(${name} OBJECT ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:praxis_options> Boost::headers)
endfunction()
