# Until there are releases to download, WEFT_ARCHIVE names the tarball that `make dist` makes.
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "$ENV{WEFT_ARCHIVE}")
vcpkg_check_features(OUT_FEATURE_OPTIONS options FEATURES double WEFT_DOUBLE)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}/tangle/packaging/cmake" OPTIONS ${options} -DCMAKE_INSTALL_LIBDIR=lib)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/weft)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
