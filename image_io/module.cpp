#include "image_io/module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

#include "frame/frame_error.h"
#include "image_io/frame_files.h"
#include "image_io/image_file.h"

namespace zproof::image_io {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& reason) {
    throw FrameError(
        "images cannot be read or written: " + file + ": " + reason +
        "; expected zproof's image module beside the program or in its library folder, and "
        "OpenImageIO (Debian's package libopenimageio2.4); ZPROOF_IMAGE_IO=FILE names the module");
}

const ModuleTable& load() {
    const char* named = std::getenv("ZPROOF_IMAGE_IO");
    const std::string file = named != nullptr && *named != '\0' ? named : "zproof_image_io.so";
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) refuse(file, dlerror());
    const auto table_of = reinterpret_cast<TableFunction>(dlsym(library, table_function_name));
    if (table_of == nullptr) refuse(file, "it is no image module of zproof");
    const ModuleTable& table = *table_of();
    if (table.interface != interface_number)
        refuse(file, "it has the interface " + std::to_string(table.interface) + ", this program needs " +
                         std::to_string(interface_number));
    return table;
}

}  // namespace

const ModuleTable& module() {
    static const ModuleTable& loaded = load();
    return loaded;
}

void load_module() {
    try {
        module();
    } catch (const FrameError&) {
        return;
    }
}

void load_module_for(const std::filesystem::path& image) {
    const FrameFiles files = frame_files(image);
    for (const std::filesystem::path& file : {files.ids, files.depths})
        if (const Format format = format_of(file); format != Format::unknown && format != Format::npy)
            load_module();
}

}  // namespace zproof::image_io
