#include "GltfDocument.h"

#include "Base64Text.h"
#include "JsonText.h"
#include "Refusal.h"
#include "SurfaceBytes.h"

#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* Remedy = "export it again as .glb, without compression";

// glTF's codes of component types, and the chunks of a .glb file.
constexpr std::uint64_t UnsignedByte = 5121;
constexpr std::uint64_t UnsignedShort = 5123;
constexpr std::uint64_t UnsignedInt = 5125;
constexpr std::uint64_t Float = 5126;
constexpr std::uint32_t JsonChunk = 0x4e4f534a;
constexpr std::uint32_t BinaryChunk = 0x004e4942;

std::size_t BytesOf(std::uint64_t componentType)
{
  return componentType == UnsignedByte ? 1 : componentType == UnsignedShort ? 2 : 4;
}

// A little-endian number of up to four bytes.
std::uint32_t NumberAt(std::string_view bytes, std::size_t place, std::size_t count = 4)
{
  return static_cast<std::uint32_t>(BitsOf(bytes.substr(place, count), NumberCoding::LittleEndian));
}

bool HasText(const GltfDocument::Json* value, const char* text)
{
  return value != nullptr && value->is_string() && value->get_ref<const std::string&>() == text;
}
} // namespace

GltfDocument::GltfDocument(std::string_view bytes, std::string fileName)
    : FileName(std::move(fileName))
{
  std::string_view binary;
  const bool isBinary = bytes.substr(0, 4) == "glTF";
  const std::string_view text = isBinary ? this->TakeChunks(bytes, binary) : bytes;
  this->Root = ParseJson(text, this->FileName, Remedy);
  const Json* const asset = Find(this->Root, "asset");
  if (asset == nullptr || !HasText(Find(*asset, "version"), "2.0"))
  {
    this->Refuse("it is not of version 2.0");
  }
  const Json* const required = Find(this->Root, "extensionsRequired");
  if (required != nullptr && !required->empty())
  {
    this->Refuse("it requires extensions of glTF");
  }
  this->TakeBuffers(binary);
}

void GltfDocument::Refuse(const std::string& fact) const
{
  palpate::Refuse(this->FileName, "is not a readable glTF surface: " + fact, Remedy);
}

// The JSON text of a binary file; its buffer is optional.
std::string_view GltfDocument::TakeChunks(std::string_view bytes, std::string_view& binary) const
{
  constexpr std::size_t ChunkHead = 8;
  std::size_t place = 12;
  std::string_view text;
  if (bytes.size() < place || NumberAt(bytes, 4) != 2 || NumberAt(bytes, 8) != bytes.size())
  {
    this->Refuse("it is truncated, damaged or not of version 2");
  }
  while (bytes.size() - place >= ChunkHead)
  {
    const std::uint64_t length = NumberAt(bytes, place);
    const std::uint32_t type = NumberAt(bytes, place + 4);
    place += ChunkHead;
    if (length > bytes.size() - place)
    {
      break;
    }
    const std::string_view chunk = bytes.substr(place, length);
    text = type == JsonChunk && text.empty() ? chunk : text;
    binary = type == BinaryChunk && binary.empty() ? chunk : binary;
    place += length;
  }
  if (place != bytes.size() || text.empty())
  {
    this->Refuse("its chunks are damaged");
  }
  return text;
}

void GltfDocument::TakeBuffers(std::string_view binary)
{
  const Json* const buffers = Find(this->Root, "buffers");
  for (std::size_t i = 0; buffers != nullptr && i < buffers->size(); ++i)
  {
    this->Buffers.push_back(this->BufferOf(this->Item("buffers", i), binary, i == 0));
  }
}

std::string GltfDocument::BufferOf(const Json& buffer, std::string_view binary, bool isFirst) const
{
  std::string bytes = isFirst ? std::string(binary) : std::string();
  if (const Json* const uri = Find(buffer, "uri"))
  {
    constexpr std::string_view Mark = ";base64,";
    const std::string_view text = uri->is_string()
                                      ? std::string_view(uri->get_ref<const std::string&>())
                                      : std::string_view();
    const std::size_t mark = text.substr(0, 100).find(Mark);
    if (text.substr(0, 5) != "data:" || mark == std::string_view::npos)
    {
      this->Refuse("it keeps its points in another file");
    }
    const auto decoded = DecodedBase64(text.substr(mark + Mark.size()));
    if (!decoded)
    {
      this->Refuse("its Base64 text is damaged");
    }
    bytes = *decoded;
  }
  const std::uint64_t length = this->Whole(buffer, "byteLength");
  if (length > bytes.size())
  {
    this->Refuse("it states more values than it can hold");
  }
  bytes.resize(length);
  return bytes;
}

const GltfDocument::Json* GltfDocument::Find(const Json& object, const char* key)
{
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found == object.end() ? nullptr : &*found;
}

const GltfDocument::Json& GltfDocument::Item(const char* list, std::uint64_t index) const
{
  const Json* const items = Find(this->Root, list);
  if (items == nullptr || !items->is_array() || index >= items->size())
  {
    this->Refuse("it refers to an entry of its " + std::string(list) + " that does not exist");
  }
  return (*items)[index];
}

std::uint64_t GltfDocument::WholeOf(const Json& value) const
{
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
  {
    this->Refuse("one of its indices, offsets or lengths is invalid");
  }
  return value.get<std::uint64_t>();
}

std::uint64_t GltfDocument::Whole(const Json& object, const char* key) const
{
  const Json* const value = Find(object, key);
  return this->WholeOf(value == nullptr ? Json() : *value);
}

std::uint64_t GltfDocument::Whole(const Json& object, const char* key, std::uint64_t fallback) const
{
  return Find(object, key) == nullptr ? fallback : this->Whole(object, key);
}

std::vector<std::uint64_t> GltfDocument::Wholes(const Json& object, const char* key) const
{
  std::vector<std::uint64_t> values;
  const Json* const list = Find(object, key);
  for (std::size_t i = 0; list != nullptr && list->is_array() && i < list->size(); ++i)
  {
    values.push_back(this->WholeOf((*list)[i]));
  }
  return values;
}

std::vector<double> GltfDocument::Numbers(const Json& object, const char* key,
                                          std::size_t count) const
{
  std::vector<double> values;
  const Json* const list = Find(object, key);
  for (std::size_t i = 0; list != nullptr && list->is_array() && i < list->size(); ++i)
  {
    const Json& value = (*list)[i];
    values.push_back(value.is_number() ? value.get<double>()
                                       : std::numeric_limits<double>::quiet_NaN());
  }
  if (list != nullptr && values.size() != count)
  {
    this->Refuse("the transform of one of its nodes is invalid");
  }
  return values;
}

// Numbers below 2^32, so that no sum or product of two exceeds 64 bits.
GltfDocument::Elements GltfDocument::ElementsOf(std::uint64_t accessor, const char* type,
                                                std::size_t components) const
{
  const Json& object = this->Item("accessors", accessor);
  if (Find(object, "sparse") != nullptr || !HasText(Find(object, "type"), type))
  {
    this->Refuse("its points or triangles are of a type that is not supported");
  }
  const Json& view = this->Item("bufferViews", this->Whole(object, "bufferView"));
  const std::uint64_t buffer = this->Whole(view, "buffer");
  this->Item("buffers", buffer);
  const std::string_view bytes = this->Buffers[buffer];
  const std::uint64_t first = this->Whole(view, "byteOffset", 0);
  const std::uint64_t length = this->Whole(view, "byteLength");
  const std::uint64_t own = this->Whole(object, "byteOffset", 0);
  Elements elements{};
  elements.ComponentType = this->Whole(object, "componentType");
  elements.Count = this->Whole(object, "count");
  const std::size_t size = components * BytesOf(elements.ComponentType);
  elements.Stride = this->Whole(view, "byteStride", size);
  if (elements.Count < 1 || elements.Stride < size || first + length > bytes.size() ||
      own + (elements.Count - 1) * elements.Stride + size > length)
  {
    this->Refuse("it states more values than it can hold");
  }
  elements.Bytes = bytes.substr(first + own);
  return elements;
}

std::vector<Vector3> GltfDocument::Positions(std::uint64_t accessor) const
{
  const Elements elements = this->ElementsOf(accessor, "VEC3", 3);
  if (elements.ComponentType != Float)
  {
    this->Refuse("its points are not floating-point numbers");
  }
  std::vector<Vector3> positions(elements.Count);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      positions[i].data()[k] = NumberOf(elements.Bytes.substr(i * elements.Stride + 4 * k, 4),
                                        {4, true, true}, NumberCoding::LittleEndian);
    }
  }
  return positions;
}

std::vector<std::uint32_t> GltfDocument::Indices(std::uint64_t accessor) const
{
  const Elements elements = this->ElementsOf(accessor, "SCALAR", 1);
  const std::uint64_t type = elements.ComponentType;
  if (type != UnsignedByte && type != UnsignedShort && type != UnsignedInt)
  {
    this->Refuse("its triangles are not whole numbers");
  }
  std::vector<std::uint32_t> indices(elements.Count);
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    indices[i] = NumberAt(elements.Bytes, i * elements.Stride, BytesOf(type));
  }
  return indices;
}
} // namespace palpate
