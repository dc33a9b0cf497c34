/// Files as numpy.save writes them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace zproof {

/// A file of version 1.0 with this header and these bytes behind it.
inline void write_npy(const std::filesystem::path& file, std::string header, const std::string& bytes) {
    header.resize((header.size() + 11 + 63) / 64 * 64 - 11, ' ');
    header += '\n';
    std::ofstream out(file, std::ios::binary);
    out << std::string("\x93NUMPY\x01\x00", 8) << char(header.size() & 0xFF) << char(header.size() >> 8)
        << header << bytes;
}

/// An array of this numpy type and shape, "<f4" and "2, 3".
template <class T>
void write_npy(const std::filesystem::path& file, const std::string& type, const std::string& shape,
               const std::vector<T>& values) {
    write_npy(file, "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + shape + "), }",
              std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

}  // namespace zproof
