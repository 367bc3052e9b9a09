#include "SlicerModule.h"

#include "DecimalText.h"
#include "DeclaredCommand.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace palpate::cli
{
namespace
{
std::string XmlText(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return result;
}

std::string Element(const std::string& name, const std::string& text)
{
  return "<" + name + ">" + XmlText(text) + "</" + name + ">";
}

// "max_degree" of --max-degree and "out" of OUT: letters, digits and underscores only.
std::string Identifier(const DeclaredOption& option)
{
  std::string name = option.IsPositional() ? option.Place : option.Names.back().substr(2);
  for (char& c : name)
  {
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

std::string LabelOf(const DeclaredOption& option)
{
  std::string label = Identifier(option);
  std::replace(label.begin(), label.end(), '_', ' ');
  label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

bool HasDefault(const DeclaredOption& option)
{
  return !option.Default.empty();
}

std::string TypeOf(const DeclaredOption& option)
{
  using Kind = DeclaredOption::Kind;
  if (option.Type == Kind::Flag)
  {
    return "boolean";
  }
  if (option.Type == Kind::File)
  {
    return option.File->Content == "label" ? "image" : option.File->Content;
  }
  if (option.IsList)
  {
    const std::string item = option.Type == Kind::Integer ? "integer"
                             : option.Type == Kind::Real  ? "double"
                                                          : "string";
    return option.IsCommaSeparated ? item + "-vector" : "string";
  }
  if (!HasDefault(option))
  {
    return "string";
  }
  return option.Type == Kind::Integer  ? "integer"
         : option.Type == Kind::Real   ? "double"
         : option.Type == Kind::Choice ? "string-enumeration"
                                       : "string";
}

std::string Attributes(const DeclaredOption& option)
{
  if (!option.File)
  {
    return {};
  }
  const std::string& content = option.File->Content;
  const std::string ending =
      content == "geometry" && option.File->Ending.empty() ? ".vtp" : option.File->Ending;
  return (content == "label"   ? " type=\"label\""
          : content == "image" ? " type=\"scalar\""
                               : std::string()) +
         (ending.empty() ? std::string() : " fileExtensions=\"" + ending + "\"");
}

// Fine enough that Slicer's rounding to a step changes no default.
std::string Constraints(const DeclaredOption& option)
{
  constexpr double FinestStep = 0.001;
  const auto [low, high] = *option.Range;
  const double step = option.Type == DeclaredOption::Kind::Integer ? 1.0 : FinestStep;
  return "      <constraints>" + Element("minimum", SignificantText(low)) +
         Element("maximum", SignificantText(high)) + Element("step", SignificantText(step)) +
         "</constraints>\n";
}

std::string Parameter(const DeclaredOption& option, int index)
{
  const std::string type = TypeOf(option);
  std::ostringstream xml;
  xml << "    <" << type << Attributes(option) << ">\n      " << Element("name", Identifier(option))
      << "\n      ";
  if (option.IsPositional())
  {
    xml << Element("index", std::to_string(index));
  }
  else
  {
    xml << Element("longflag", "--" + Identifier(option));
  }
  xml << "\n      " << Element("label", LabelOf(option)) << "\n      "
      << Element("description", option.Help) << "\n";
  if (option.File)
  {
    xml << "      " << Element("channel", option.File->IsOutput ? "output" : "input") << "\n";
  }
  else if (type == "boolean" || HasDefault(option))
  {
    xml << "      " << Element("default", type == "boolean" ? "false" : option.Default) << "\n";
  }
  if (type == "string-enumeration")
  {
    for (const std::string& value : option.Values)
    {
      xml << "      " << Element("element", value) << "\n";
    }
  }
  if (option.Range && (type == "integer" || type == "double"))
  {
    xml << Constraints(option);
  }
  xml << "    </" << type << ">\n";
  return xml.str();
}

std::string Group(const std::string& label, const std::string& help, const std::string& parameters)
{
  return parameters.empty()
             ? std::string()
             : "  <parameters>\n    " + Element("label", label) + "\n    " +
                   Element("description", help) + "\n" + parameters + "  </parameters>\n";
}
} // namespace

std::string SlicerModule(const DeclaredCommand& command, const std::string& version)
{
  std::string files;
  std::string settings;
  int index = 0;
  for (const DeclaredOption& option : command.Options)
  {
    if (!option.HasName("--help") && !option.HasName("--xml"))
    {
      const std::string parameter = Parameter(option, index);
      index += option.IsPositional() ? 1 : 0;
      (option.File ? files : settings) += parameter;
    }
  }
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<executable>\n  " +
         Element("category", "Palpate") + "\n  " + Element("title", "Palpate " + command.Name) +
         "\n  " + Element("description", command.Help) + "\n  " + Element("version", version) +
         "\n  <documentation-url></documentation-url>\n  " + Element("license", "BSD-3-Clause") +
         "\n  " + Element("contributor", "The Palpate authors") + "\n" +
         Group("Files", "Input and output", files) +
         Group("Settings", "How " + command.Name + " works", settings) + "</executable>\n";
}
} // namespace palpate::cli
