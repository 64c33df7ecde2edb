"""conan create tangle/packaging/conan: the engine by CMake, from the committed C."""
import os
from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Weft(ConanFile):
    name = 'weft'
    version = '0.1.0'
    license = 'MIT'
    description = '2D rigid-body physics with the same bits on every machine'
    settings = 'os', 'arch', 'compiler', 'build_type'
    options = {'shared': [True, False], 'fPIC': [True, False], 'double': [True, False]}
    default_options = {'shared': False, 'fPIC': True, 'double': False}
    languages = 'C'
    implements = ['auto_shared_fpic']

    def export_sources(self):
        top = os.path.join(self.recipe_folder, '..', '..', '..')
        for pattern in ('Makefile', 'LICENSE', 'tangle/*.in', 'tangle/old_names.h', 'src-generated/*',
                        'tangle/packaging/cmake/*'):
            copy(self, pattern, top, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables['WEFT_DOUBLE'] = bool(self.options.double)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder='tangle/packaging/cmake')
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, 'LICENSE', self.source_folder, os.path.join(self.package_folder, 'licenses'))

    def package_info(self):
        self.cpp_info.libs = ['weft']
        self.cpp_info.defines = ['WF_DOUBLE'] if self.options.double else []
        if self.settings.os in ('Linux', 'FreeBSD'):
            self.cpp_info.system_libs = ['m']
