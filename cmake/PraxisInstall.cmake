# cmake --install and find_package(praxis).
