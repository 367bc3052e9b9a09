#pragma once

#include "Vector3.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/// A glTF 2.0 file's description and the values of its accessors. Every failure is an InputError
/// that names the file; no text of the file is repeated.
class GltfDocument
{
public:
  using Json = nlohmann::json;

  /// Parses a text (.gltf) or binary (.glb) file. Refuses buffers in other files and extensions
  /// that a reader must know.
  GltfDocument(std::string_view bytes, std::string fileName);

  [[noreturn]] void Refuse(const std::string& fact) const;

  /// Member of an object; null if it is absent.
  static const Json* Find(const Json& object, const char* key);
  /// Entry of a list of the description ("nodes", "meshes", ...). Refuses an index beyond its end.
  const Json& Item(const char* list, std::uint64_t index) const;
  /// A whole number of an object below 2^32; the fallback if it is absent.
  std::uint64_t Whole(const Json& object, const char* key) const;
  std::uint64_t Whole(const Json& object, const char* key, std::uint64_t fallback) const;
  /// The whole numbers below 2^32 of a list, or the numbers of one of a fixed length; empty if it
  /// is absent.
  std::vector<std::uint64_t> Wholes(const Json& object, const char* key) const;
  std::vector<double> Numbers(const Json& object, const char* key, std::size_t count) const;
  const Json& Description() const { return this->Root; }

  /// Values of an accessor, which must lie within its buffer.
  std::vector<Vector3> Positions(std::uint64_t accessor) const;
  std::vector<std::uint32_t> Indices(std::uint64_t accessor) const;

private:
  struct Elements
  {
    std::string_view Bytes; // from the first element
    std::size_t Count;
    std::size_t Stride;
    std::uint64_t ComponentType;
  };

  std::string_view TakeChunks(std::string_view bytes, std::string_view& binary) const;
  void TakeBuffers(std::string_view binary);
  std::string BufferOf(const Json& buffer, std::string_view binary, bool isFirst) const;
  std::uint64_t WholeOf(const Json& value) const;
  Elements ElementsOf(std::uint64_t accessor, const char* type, std::size_t components) const;

  std::string FileName;
  Json Root;
  std::vector<std::string> Buffers;
};
} // namespace palpate
