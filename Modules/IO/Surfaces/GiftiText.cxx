#include "GiftiText.h"

#include "Refusal.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <limits>
#include <string_view>

namespace palpate
{
namespace
{
// Collects the arrays while expat reads. Exceptions must not pass through expat, so the first
// problem is kept.
class GiftiParser : public vtkXMLParser
{
public:
  vtkTypeMacro(GiftiParser, vtkXMLParser);
  static GiftiParser* New();

  GiftiArrays Found;
  std::string Problem;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    const std::string_view element = name;
    this->Depth += 1;
    this->Text = nullptr;
    if (this->Depth == 1 && element != "GIFTI")
    {
      this->Fail("it has no GIFTI element");
    }
    else if (this->Depth == 2 && element == "DataArray")
    {
      this->StartArray(attributes);
    }
    else if (this->Current != nullptr)
    {
      this->StartPart(element);
    }
  }

  void EndElement(const char* name) override
  {
    if (this->Depth == 3 && std::string_view(name) == "CoordinateSystemTransformMatrix" &&
        this->Current != nullptr &&
        this->Space.find("NIFTI_XFORM_SCANNER_ANAT") != std::string::npos)
    {
      this->Current->ToScanner = this->Matrix;
    }
    this->Depth -= 1;
    this->Text = nullptr;
    this->Current = this->Depth < 2 ? nullptr : this->Current;
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    if (this->Text != nullptr)
    {
      this->Text->append(data, static_cast<std::size_t>(length));
    }
  }

  // The message would be printed.
  void ReportXmlParseError() override { this->Fail("it is not complete XML"); }

private:
  void Fail(const std::string& problem)
  {
    this->Problem = this->Problem.empty() ? problem : this->Problem;
  }

  void StartArray(const char** attributes)
  {
    GiftiArray array;
    std::string intent;
    bool isFlat = true;
    const std::pair<std::string_view, std::string*> fields[] = {
        {"Intent", &intent},
        {"DataType", &array.Type},
        {"Encoding", &array.Encoding},
        {"ArrayIndexingOrder", &array.Order},
        {"Endian", &array.Endian}};
    for (const char** place = attributes; place[0] != nullptr; place += 2)
    {
      const std::string_view key = place[0];
      for (const auto& [name, value] : fields)
      {
        *value = key == name ? place[1] : *value;
      }
      if (key == "Dim0" || key == "Dim1")
      {
        array.Sizes[key == "Dim0" ? 0 : 1] = place[1];
      }
      isFlat = isFlat && key != "Dim2";
    }
    array.Sizes = isFlat ? array.Sizes : decltype(array.Sizes)();
    this->Keep(intent, array);
  }

  void Keep(const std::string& intent, const GiftiArray& array)
  {
    std::optional<GiftiArray>* kept = intent == "NIFTI_INTENT_POINTSET"   ? &this->Found.Points
                                      : intent == "NIFTI_INTENT_TRIANGLE" ? &this->Found.Triangles
                                                                          : nullptr;
    if (kept == nullptr)
    {
      return;
    }
    if (kept->has_value())
    {
      this->Fail("it has more than one array of points or of triangles");
    }
    this->Current = &kept->emplace(array);
  }

  // What is inside of an array that is kept.
  void StartPart(std::string_view element)
  {
    if (this->Depth == 3 && element == "Data")
    {
      this->Text = &this->Current->Data;
    }
    else if (this->Depth == 3)
    {
      this->Space.clear();
      this->Matrix.clear();
    }
    else if (this->Depth == 4 && element == "TransformedSpace")
    {
      this->Text = &this->Space;
    }
    else if (this->Depth == 4 && element == "MatrixData")
    {
      this->Text = &this->Matrix;
    }
  }

  std::size_t Depth = 0;
  GiftiArray* Current = nullptr; // the array that is being read, if it is kept
  std::string* Text = nullptr;   // where the present element's text goes
  std::string Space;
  std::string Matrix;
};

vtkStandardNewMacro(GiftiParser);
} // namespace

GiftiArrays GiftiArraysOf(const std::string& text, const std::string& fileName)
{
  vtkNew<GiftiParser> parser;
  // Entities could expand to gigabytes; GIfTI has none.
  if (text.find("<!ENTITY") != std::string::npos)
  {
    Refuse(fileName, "is not a readable GIfTI surface: it declares entities", "write it again");
  }
  if (text.size() > std::numeric_limits<int>::max())
  {
    Refuse(fileName, "has more than 2 GB of text", "use a coarser surface");
  }
  bool isComplete = parser->InitializeParser() != 0;
  // In one piece: expat would read a long token again with every piece of it.
  isComplete =
      isComplete && parser->ParseChunk(text.data(), static_cast<unsigned int>(text.size())) != 0;
  isComplete = parser->CleanupParser() != 0 && isComplete;
  if (!isComplete && parser->Problem.empty())
  {
    parser->Problem = "it is not complete XML";
  }
  if (!parser->Problem.empty())
  {
    Refuse(fileName, "is not a readable GIfTI surface: " + parser->Problem, "write it again");
  }
  return parser->Found;
}
} // namespace palpate
