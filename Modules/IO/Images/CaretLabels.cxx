#include "CaretLabels.h"

#include "DecimalText.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace palpate
{
namespace
{
class CaretParser : public vtkXMLParser
{
public:
  vtkTypeMacro(CaretParser, vtkXMLParser);
  static CaretParser* New();

  LabelTable Found;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    const std::string_view element = name;
    this->IsCaret = this->IsCaret || element == "CaretExtension";
    this->Current = nullptr;
    if (this->IsCaret && !this->IsOver && element == "Label")
    {
      this->StartLabel(attributes);
    }
  }

  void EndElement(const char* name) override
  {
    this->Current = nullptr;
    this->IsOver = this->IsOver || std::string_view(name) == "LabelTable";
  }

  void CharacterDataHandler(const char* data, int length) override
  {
    if (this->Current != nullptr)
    {
      this->Current->append(data, static_cast<std::size_t>(length));
    }
  }

  // The message would be printed.
  void ReportXmlParseError() override {}

private:
  void StartLabel(const char** attributes)
  {
    constexpr std::array<std::string_view, 3> Channels{"Red", "Green", "Blue"};
    std::array<double, 3> color{};
    std::size_t channels = 0;
    std::optional<int> key;
    for (const char** place = attributes; place[0] != nullptr; place += 2)
    {
      const std::string_view name = place[0];
      const auto* channel = std::find(Channels.begin(), Channels.end(), name);
      const std::optional<double> value = ParseNumber(place[1]);
      if (name == "Key")
      {
        key = ParseInteger(place[1]);
      }
      else if (channel != Channels.end() && value)
      {
        color[static_cast<std::size_t>(channel - Channels.begin())] = std::clamp(*value, 0.0, 1.0);
        ++channels;
      }
    }
    if (key)
    {
      LabelEntry& entry = this->Found[*key] = {};
      entry.Color = channels == color.size() ? std::optional(color) : std::nullopt;
      this->Current = &entry.Name;
    }
  }

  bool IsCaret = false;
  bool IsOver = false; // the tables of further volumes
  std::string* Current = nullptr;
};

vtkStandardNewMacro(CaretParser);

// Character data end at "]]>".
std::string CData(std::string text)
{
  for (std::size_t place = 0; (place = text.find("]]>", place)) != std::string::npos; place += 3)
  {
    text.insert(place + 2, "]]><![CDATA[");
  }
  // Control characters are no XML.
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return "<![CDATA[" + text + "]]>";
}
} // namespace

std::optional<LabelTable> LabelsOfCaret(const std::string& xml)
{
  // Entities could expand to gigabytes; these texts have none, and are not in UTF-16.
  const bool isBounded = xml.size() <= std::numeric_limits<int>::max() &&
                         xml.find("<!ENTITY") == std::string::npos &&
                         xml.find('\0') == std::string::npos;
  vtkNew<CaretParser> parser;
  const bool isXml = isBounded && parser->InitializeParser() != 0 &&
                     parser->ParseChunk(xml.data(), static_cast<unsigned int>(xml.size())) != 0;
  const bool isWhole = isBounded && parser->CleanupParser() != 0 && isXml;
  return isWhole && !parser->Found.empty() ? std::optional(parser->Found) : std::nullopt;
}

std::string CaretTextOf(const LabelTable& table)
{
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<CaretExtension>"
                     "<VolumeInformation Index=\"0\"><LabelTable>\n";
  for (const auto& [value, entry] : table)
  {
    const auto color = entry.Color.value_or(std::array<double, 3>{1.0, 1.0, 1.0});
    text += "<Label Key=\"" + std::to_string(value) + "\" Red=\"" + ExactText(color[0]) +
            "\" Green=\"" + ExactText(color[1]) + "\" Blue=\"" + ExactText(color[2]) +
            "\" Alpha=\"1\">" + CData(entry.Name) + "</Label>\n";
  }
  return text + "</LabelTable><VolumeType><![CDATA[Label]]></VolumeType></VolumeInformation>"
                "</CaretExtension>\n";
}
} // namespace palpate
