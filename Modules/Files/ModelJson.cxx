#include "ModelJson.h"

#include "ComplianceJson.h"
#include "JsonText.h"
#include "ModelConvention.h"
#include "Refusal.h"
#include "SphericalHarmonicBasis.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
// Keys stay in the order in which they are written, so that files read well and compare equal.
using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> CoordinateKeys{{"x", "y", "z"}};

// The entries that are the same in every file.
Json ConventionAsJson()
{
  Json basis;
  basis["kind"] = ModelConvention::Basis;
  basis["normalization"] = ModelConvention::Normalization;
  basis["phase"] = ModelConvention::Phase;
  basis["polar_axis"] = ModelConvention::PolarAxis;
  basis["order"] = ModelConvention::Order;
  basis["signs"] = ModelConvention::Signs;
  return basis;
}

Json AsJson(const ModelProvenance& provenance)
{
  Json result = Json::object();
  const auto add = [&result](const char* key, const std::string& value)
  {
    if (!value.empty())
    {
      result[key] = value;
    }
  };
  add("program", provenance.Program);
  add("input", provenance.Input);
  add("label", provenance.Label);
  add("date", provenance.Date);
  for (const auto& [name, value] : provenance.Settings)
  {
    result["settings"][name] = value;
  }
  return result;
}

const std::vector<double>& Finite(const std::vector<double>& values, const std::string& fileName)
{
  for (const double value : values)
  {
    if (!std::isfinite(value))
    {
      Refuse(fileName, "cannot be written: a coefficient is not a finite number",
             "fit the model again");
    }
  }
  return values;
}

void AddSurface(const RadialModel& model, const std::string& fileName, Json& file)
{
  const Vector3& center = model.CenterWorld();
  file["center_mm"] = Finite({center.x(), center.y(), center.z()}, fileName);
  file["coefficients_mm"] = Finite(model.Coefficients(), fileName);
}

void AddSurface(const SurfaceModel& surface, const std::string& fileName, Json& file)
{
  for (int k = 0; k < 3; ++k)
  {
    file["coefficients_mm"][CoordinateKeys[static_cast<std::size_t>(k)]] =
        Finite(surface.Coefficients(k), fileName);
  }
}

/// Extracts a model from a parsed file; every member throws InputError with the file's name.
class Reader
{
public:
  Reader(const Json& root, const std::string& name) : File(root), FileName(name) {}

  ModelDocument Document() const
  {
    this->CheckConvention();
    const int degree = this->Degree();
    const std::string kind = this->Kind();
    ModelProvenance provenance = this->Provenance();
    if (kind == ModelConvention::Radial)
    {
      const std::vector<double> center = this->Numbers(this->File, "center_mm", 3);
      return {RadialModel(degree,
                          this->Numbers(this->File, "coefficients_mm",
                                        SphericalHarmonicBasis::CoefficientCount(degree)),
                          Vector3(center[0], center[1], center[2])),
              std::move(provenance), this->Elasticity()};
    }
    if (kind == ModelConvention::Surface)
    {
      return {SurfaceModel(degree, this->Coordinates(degree)), std::move(provenance)};
    }
    this->Refuse("its model is \"" + kind + "\", which this version of Palpate does not know",
                 "convert it to \"radial\" or \"surface\"");
  }

private:
  [[noreturn]] void Refuse(const std::string& fact, const std::string& remedy) const
  {
    palpate::Refuse(this->FileName, "is not a model that Palpate can read: " + fact, remedy);
  }
  [[noreturn]] void RefuseEntry(const std::string& key, const std::string& what) const
  {
    this->Refuse("its entry \"" + key + "\" " + what, "write the file again with palpate");
  }

  const Json& Entry(const Json& parent, const std::string& key) const
  {
    if (!parent.is_object() || !parent.contains(key))
    {
      this->RefuseEntry(key, "is missing");
    }
    return parent[key];
  }

  std::string Text(const Json& parent, const std::string& key) const
  {
    const Json& entry = this->Entry(parent, key);
    if (!entry.is_string())
    {
      this->RefuseEntry(key, "is not text");
    }
    return entry.get<std::string>();
  }

  void Expect(const Json& parent, const std::string& key, const std::string& expected) const
  {
    const std::string found = this->Text(parent, key);
    if (found != expected)
    {
      this->Refuse("its " + key + " is \"" + found + "\", not \"" + expected + "\"",
                   "convert its coefficients first");
    }
  }

  void CheckConvention() const
  {
    if (!this->File.is_object() || !this->File.contains("format"))
    {
      this->Refuse("it does not state its format", "specify a file that palpate fit wrote");
    }
    this->Expect(this->File, "format", ModelConvention::Format);
    const Json& version = this->Entry(this->File, "version");
    if (version != ModelConvention::Version && !this->IsFirstVersion())
    {
      this->Refuse(
          "its version is " + version.dump(-1, ' ', false, Json::error_handler_t::replace) +
              ", and this program reads versions 1 to " + std::to_string(ModelConvention::Version),
          "use the version of Palpate that wrote it");
    }
    const Json& basis = this->Entry(this->File, "basis");
    const Json expected = ConventionAsJson();
    for (const auto& [key, value] : expected.items())
    {
      this->Expect(basis, key, value.get<std::string>());
    }
    this->Expect(this->File, "frame", ModelConvention::Frame);
    this->Expect(this->File, "unit", ModelConvention::Unit);
  }

  bool IsFirstVersion() const { return this->Entry(this->File, "version") == 1; }

  // Version 1 says "surface", and "star-shaped" or "parametric".
  std::string Kind() const
  {
    if (!this->IsFirstVersion())
    {
      return this->Text(this->File, "model");
    }
    const std::string kind = this->Text(this->File, "surface");
    return kind == "star-shaped"  ? ModelConvention::Radial
           : kind == "parametric" ? ModelConvention::Surface
                                  : "called " + kind;
  }

  int Degree() const
  {
    const Json& entry = this->Entry(this->File, "degree");
    const bool fits = entry.is_number_unsigned() &&
                      entry.get<std::uint64_t>() <= std::uint64_t{ModelConvention::MaximumDegree};
    if (!fits)
    {
      this->RefuseEntry("degree", "is not a whole number from 0 to " +
                                      std::to_string(ModelConvention::MaximumDegree));
    }
    return entry.get<int>();
  }

  std::vector<double> Numbers(const Json& parent, const std::string& key, std::size_t count) const
  {
    const Json& entry = this->Entry(parent, key);
    if (!entry.is_array() || entry.size() != count)
    {
      this->RefuseEntry(key, "is not a list of " + std::to_string(count) + " numbers");
    }
    std::vector<double> values;
    values.reserve(count);
    for (const Json& value : entry)
    {
      if (!value.is_number() || !std::isfinite(value.get<double>()))
      {
        this->RefuseEntry(key, "holds a value that is not a finite number");
      }
      values.push_back(value.get<double>());
    }
    return values;
  }

  std::array<std::vector<double>, 3> Coordinates(int degree) const
  {
    const Json& entry = this->Entry(this->File, "coefficients_mm");
    std::array<std::vector<double>, 3> coordinates;
    for (std::size_t k = 0; k < coordinates.size(); ++k)
    {
      coordinates[k] =
          this->Numbers(entry, CoordinateKeys[k], SphericalHarmonicBasis::CoefficientCount(degree));
    }
    return coordinates;
  }

  std::shared_ptr<const ComplianceMaps> Elasticity() const
  {
    const auto found = this->File.find("elasticity");
    return found != this->File.end()
               ? std::make_shared<const ComplianceMaps>(ComplianceFromJson(*found, this->FileName))
               : nullptr;
  }

  // Provenance is informative: it may be absent, and unknown entries are ignored.
  ModelProvenance Provenance() const
  {
    ModelProvenance result;
    const auto found = this->File.find("provenance");
    if (found == this->File.end() || !found->is_object())
    {
      return result;
    }
    const auto text = [&found](const char* key)
    {
      const auto entry = found->find(key);
      return entry != found->end() && entry->is_string() ? entry->get<std::string>()
                                                         : std::string();
    };
    result.Program = text("program");
    result.Input = text("input");
    result.Label = text("label");
    result.Date = text("date");
    const auto settings = found->find("settings");
    if (settings != found->end() && settings->is_object())
    {
      for (const auto& [name, value] : settings->items())
      {
        result.Settings.emplace_back(name, value.is_string() ? value.get<std::string>() : "");
      }
    }
    return result;
  }

  const Json& File;
  const std::string& FileName;
};
} // namespace

std::string ModelToJson(const ModelDocument& document, const std::string& fileName)
{
  const bool isRadial = std::holds_alternative<RadialModel>(document.Surface);
  Json file;
  file["format"] = ModelConvention::Format;
  file["version"] = ModelConvention::Version;
  file["model"] = isRadial ? ModelConvention::Radial : ModelConvention::Surface;
  file["basis"] = ConventionAsJson();
  file["frame"] = ModelConvention::Frame;
  file["unit"] = ModelConvention::Unit;
  file["degree"] = std::visit([](const auto& s) { return s.Degree(); }, document.Surface);
  std::visit([&](const auto& surface) { AddSurface(surface, fileName, file); }, document.Surface);
  if (document.Elasticity)
  {
    file["elasticity"] = ComplianceAsJson(*document.Elasticity, fileName);
  }
  file["provenance"] = AsJson(document.Provenance);
  // Names that are not UTF-8 lose the bytes that JSON cannot represent.
  return file.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ModelDocument ModelFromJson(const std::string& text, const std::string& fileName)
{
  const Json root = ParseOrderedJson(text, fileName, "write it again with palpate");
  return Reader(root, fileName).Document();
}
} // namespace palpate
