#pragma once

#include "TriangleMesh.h"

#include <cstdint>
#include <string>

namespace palpate
{
/// Whether the bytes of an STL file are text: they start with solid and name a facet or the end of
/// the solid, in any case, and are not as long as their triangles would be in a binary file, whose
/// comment may start like that.
bool IsStlText(const std::string& bytes);

/// The length of a binary STL file by its count of triangles, of which there are none if it ends
/// before the count.
std::uint64_t BinaryStlBytes(const std::string& bytes);

/// The triangles of a text STL file, with equal points merged, in single precision, as VTK's reader
/// has them; that reads lines of up to 255 characters and keywords in lower case only. Solids are
/// one surface; normals are not read. Throws InputError, naming `file`, for a text that is cut off
/// or has a vertex that is not three numbers.
TriangleMesh MeshFromStlText(const std::string& text, const std::string& file);
} // namespace palpate
