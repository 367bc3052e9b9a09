#include "StudyJson.h"

#include "DrillLimits.h"
#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"
#include "StudyFitJson.h"
#include "TouchToolJson.h"
#include "TouchWords.h"

#include <algorithm>

namespace palpate
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

constexpr const char* Format = "palpate-study";
constexpr int Version = 1;
constexpr double LargestPlace = 1e6;     // mm, of coordinates
constexpr double LargestStiffness = 1e4; // N/mm
constexpr double LargestFriction = 10.0;
constexpr double LargestIntensity = 1e300;

const std::initializer_list<const char*> LeftHandedWords{"refuse", "reverse"};
const std::initializer_list<const char*> AppearanceWords{"automatic", "model", "surface",
                                                         "error-map", "sub-voxel"};
const std::initializer_list<const char*> DialWords{
    "by-hand",      "automatic",    "harmonics-4",      "harmonics-8",
    "harmonics-12", "harmonics-16", "sub-voxel-linear", "sub-voxel-cubic"};
const std::initializer_list<const char*> AxesWords{"patient", "camera"};
const std::initializer_list<const char*> SliceAxesWords{"patient", "volume"};

OrderedJson Numbers(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

template <typename T>
void AddIfGiven(OrderedJson& object, const char* key, const std::optional<T>& value)
{
  if (value)
  {
    if constexpr (std::is_same_v<T, Vector3>)
    {
      object[key] = Numbers(*value);
    }
    else
    {
      object[key] = *value;
    }
  }
}

// Calls `read` with a value to be filled where the object has the entry.
template <typename T, typename Read>
void ReadIfGiven(JsonFields& fields, const char* key, std::optional<T>& value, const Read& read)
{
  if (fields.Has(key))
  {
    T given{};
    read(given);
    value = given;
  }
}

void ReadIfGiven(JsonFields& fields, const char* key, std::optional<double>& value, double least,
                 double most)
{
  ReadIfGiven(fields, key, value, [&](double& given) { fields.Read(key, given, least, most); });
}

void ReadPlace(JsonFields& fields, const char* key, Vector3& place)
{
  fields.Read(key, place, -LargestPlace, LargestPlace);
}

// Takes a session's root apart.
class StudyReader
{
public:
  StudyReader(const nlohmann::json& root, const std::filesystem::path& folder,
              const std::filesystem::path& file)
      : Root(root), Folder(folder), File(file)
  {
  }

  StudyState Read() const
  {
    StudyState state;
    JsonFields fields(this->Root, this->File, "study");
    this->CheckFormat(fields);
    this->ReadFiles(fields, state);
    this->ForEach(fields, "structures", state.Structures, &StudyReader::ReadStructure);
    if (fields.Has("fit"))
    {
      state.Fit = ReadFitSettings(this->Root["fit"], this->File);
    }
    this->ReadField(fields, state);
    if (fields.Has("tool"))
    {
      state.Tool = ReadTouchTool(this->Root["tool"], this->File);
    }
    fields.Read("device", state.Device);
    fields.Read("rate_hz", state.Rate, 1.0, 1e5);
    fields.ReadChoice("dial", DialWords, state.Dial);
    this->ReadDrill(fields, state.Drill);
    this->ReadPlacement(fields, state.Placement);
    this->ForEach(fields, "landmarks", state.Landmarks, &StudyReader::ReadLandmark);
    this->ForEach(fields, "distances", state.Distances, &StudyReader::ReadDistance);
    this->ReadView(fields, state.View);
    fields.RefuseOthers();
    return state;
  }

private:
  void CheckFormat(JsonFields& fields) const
  {
    std::string format;
    int version = Version;
    fields.Read("format", format);
    if (format != Format)
    {
      Refuse(this->File, "does not say that it is a Palpate session",
             "begin it with \"format\": \"" + std::string(Format) + "\"");
    }
    fields.Read("version", version, 1, 1000);
    if (version > Version)
    {
      Refuse(this->File,
             "is a session of version " + std::to_string(version) + ", newer than this program's " +
                 std::to_string(Version),
             "open it with a newer Palpate");
    }
  }

  std::filesystem::path ReadPath(JsonFields& fields, const char* key) const
  {
    std::string text;
    fields.Read(key, text);
    return text.empty() ? std::filesystem::path()
                        : (this->Folder / std::filesystem::u8path(text)).lexically_normal();
  }

  void ReadFiles(JsonFields& fields, StudyState& state) const
  {
    state.VolumeFile = this->ReadPath(fields, "volume");
    fields.Read("dicom_series", state.DicomSeries);
    state.SegmentationFile = this->ReadPath(fields, "segmentation");
    fields.ReadChoice("left_handed", LeftHandedWords, state.LeftHanded);
  }

  // Every object of the list `key`.
  template <typename T>
  void ForEach(JsonFields& fields, const std::string& key, std::vector<T>& values,
               T (*read)(JsonFields& fields)) const
  {
    if (!fields.Has(key.c_str()))
    {
      return;
    }
    const nlohmann::json& list = this->Root[key];
    if (!list.is_array())
    {
      Refuse(this->File, "cannot be read: its \"" + key + "\" is no list",
             "write it as [ { ... }, ... ]");
    }
    for (const nlohmann::json& object : list)
    {
      JsonFields entry(object, this->File, key + "[" + std::to_string(values.size()) + "]");
      values.push_back(read(entry));
      entry.RefuseOthers();
    }
  }

  static StudyStructure ReadStructure(JsonFields& fields)
  {
    StudyStructure structure;
    fields.Read("label", structure.Label, 0, 1'000'000'000);
    fields.Read("name", structure.Name);
    Vector3 color(structure.Color[0], structure.Color[1], structure.Color[2]);
    fields.Read("color", color, 0.0, 1.0);
    structure.Color = {{color[0], color[1], color[2]}};
    fields.Read("visible", structure.IsVisible);
    fields.Read("touchable", structure.IsTouchable);
    fields.ReadChoice("shown_as", AppearanceWords, structure.Appearance);
    fields.ReadChoice("representation", RepresentationWords, structure.Representation);
    fields.Read("degree", structure.Degree, 0, 64);
    fields.Read("stiffness_n_per_mm", structure.Stiffness, 0.0, LargestStiffness);
    fields.Read("static_friction", structure.Friction.Static, 0.0, LargestFriction);
    fields.Read("dynamic_friction", structure.Friction.Dynamic, 0.0, LargestFriction);
    fields.Read("drill_wear_mm_per_nm", structure.Drill.Wear, 0.0, DrillLimits::Wear);
    fields.Read("drill_drag_s_per_mm", structure.Drill.Drag, 0.0, DrillLimits::Drag);
    fields.Read("drill_vibration", structure.Drill.Vibration, 0.0, 1.0);
    fields.Read("forbidden", structure.IsForbidden);
    fields.Read("alarm_mm", structure.AlarmDistance, 0.0, DrillLimits::Alarm);
    return structure;
  }

  static StudyLandmark ReadLandmark(JsonFields& fields)
  {
    StudyLandmark landmark;
    fields.Read("name", landmark.Name);
    ReadPlace(fields, "position_mm", landmark.PositionWorld);
    return landmark;
  }

  static StudyDistance ReadDistance(JsonFields& fields)
  {
    StudyDistance distance;
    fields.Read("name", distance.Name);
    ReadPlace(fields, "from_mm", distance.FromWorld);
    ReadPlace(fields, "to_mm", distance.ToWorld);
    return distance;
  }

  void ReadField(JsonFields& fields, StudyState& state) const
  {
    if (fields.Has("field"))
    {
      JsonFields field(this->Root["field"], this->File, "field");
      field.ReadChoice("interpolation", InterpolationWords, state.Interpolation);
      field.Read("smoothing_voxels", state.FieldSmoothing, 0.0, 8.0);
      field.RefuseOthers();
    }
  }

  void ReadDrill(JsonFields& fields, TouchDrillSettings& drill) const
  {
    if (fields.Has("drill"))
    {
      JsonFields entry(this->Root["drill"], this->File, "drill");
      entry.Read("turns_per_s", drill.Turns, 0.0, DrillLimits::Turns);
      entry.Read("vibration_hz", drill.VibrationFrequency, 0.0, DrillLimits::Vibration);
      entry.RefuseOthers();
    }
  }

  void ReadPlacement(JsonFields& fields, StudyPlacement& placement) const
  {
    if (fields.Has("placement"))
    {
      JsonFields place(this->Root["placement"], this->File, "placement");
      ReadIfGiven(place, "scale", placement.Scale, 1e-3, 1e3);
      ReadIfGiven(place, "center_mm", placement.CenterWorld,
                  [&](Vector3& center) { ReadPlace(place, "center_mm", center); });
      place.ReadChoice("axes", AxesWords, placement.AxesFollowCamera);
      place.RefuseOthers();
    }
  }

  void ReadView(JsonFields& fields, StudyView& view) const
  {
    if (fields.Has("view"))
    {
      JsonFields look(this->Root["view"], this->File, "view");
      ReadIfGiven(look, "crosshair_mm", view.CrosshairWorld,
                  [&](Vector3& place) { ReadPlace(look, "crosshair_mm", place); });
      ReadIfGiven(look, "window", view.Window, 0.0, LargestIntensity);
      ReadIfGiven(look, "level", view.Level, -LargestIntensity, LargestIntensity);
      look.Read("layout", view.Layout);
      look.Read("overlay_opacity", view.OverlayOpacity, 0.0, 1.0);
      look.ReadChoice("slice_axes", SliceAxesWords, view.UsesVolumeAxes);
      look.Read("slices_follow_probe", view.SlicesFollowProbe);
      look.RefuseOthers();
    }
  }

  const nlohmann::json& Root;
  const std::filesystem::path& Folder;
  const std::filesystem::path& File;
};

OrderedJson AsJson(const StudyStructure& structure)
{
  return {{"label", structure.Label},
          {"name", structure.Name},
          {"color", structure.Color},
          {"visible", structure.IsVisible},
          {"touchable", structure.IsTouchable},
          {"shown_as", WordOf(AppearanceWords, structure.Appearance)},
          {"representation", WordOf(RepresentationWords, structure.Representation)},
          {"degree", structure.Degree},
          {"stiffness_n_per_mm", structure.Stiffness},
          {"static_friction", structure.Friction.Static},
          {"dynamic_friction", structure.Friction.Dynamic},
          {"drill_wear_mm_per_nm", structure.Drill.Wear},
          {"drill_drag_s_per_mm", structure.Drill.Drag},
          {"drill_vibration", structure.Drill.Vibration},
          {"forbidden", structure.IsForbidden},
          {"alarm_mm", structure.AlarmDistance}};
}

OrderedJson AsJson(const StudyLandmark& landmark)
{
  return {{"name", landmark.Name}, {"position_mm", Numbers(landmark.PositionWorld)}};
}

OrderedJson AsJson(const StudyDistance& distance)
{
  return {{"name", distance.Name},
          {"from_mm", Numbers(distance.FromWorld)},
          {"to_mm", Numbers(distance.ToWorld)}};
}

template <typename T>
OrderedJson AsJson(const std::vector<T>& values)
{
  OrderedJson list = OrderedJson::array();
  for (const T& value : values)
  {
    list.push_back(AsJson(value));
  }
  return list;
}

OrderedJson AsJson(const StudyPlacement& placement)
{
  OrderedJson object = OrderedJson::object();
  AddIfGiven(object, "scale", placement.Scale);
  AddIfGiven(object, "center_mm", placement.CenterWorld);
  object["axes"] = WordOf(AxesWords, placement.AxesFollowCamera);
  return object;
}

OrderedJson AsJson(const StudyView& view)
{
  OrderedJson object = OrderedJson::object();
  AddIfGiven(object, "crosshair_mm", view.CrosshairWorld);
  AddIfGiven(object, "window", view.Window);
  AddIfGiven(object, "level", view.Level);
  object["layout"] = view.Layout;
  object["overlay_opacity"] = view.OverlayOpacity;
  object["slice_axes"] = WordOf(SliceAxesWords, view.UsesVolumeAxes);
  object["slices_follow_probe"] = view.SlicesFollowProbe;
  return object;
}

void AddPath(OrderedJson& root, const char* key, const std::filesystem::path& path,
             const std::filesystem::path& folder)
{
  if (!path.empty())
  {
    root[key] = path.lexically_proximate(folder).generic_u8string();
  }
}

OrderedJson AsJson(const StudyState& state, const std::filesystem::path& folder)
{
  OrderedJson root{{"format", Format}, {"version", Version}};
  AddPath(root, "volume", state.VolumeFile, folder);
  if (!state.DicomSeries.empty())
  {
    root["dicom_series"] = state.DicomSeries;
  }
  AddPath(root, "segmentation", state.SegmentationFile, folder);
  root["left_handed"] = WordOf(LeftHandedWords, state.LeftHanded);
  root["structures"] = AsJson(state.Structures);
  root["fit"] = FitSettingsJson(state.Fit);
  root["field"] = {{"interpolation", WordOf(InterpolationWords, state.Interpolation)},
                   {"smoothing_voxels", state.FieldSmoothing}};
  root["tool"] = TouchToolJson(state.Tool, folder);
  root["drill"] = {{"turns_per_s", state.Drill.Turns},
                   {"vibration_hz", state.Drill.VibrationFrequency}};
  root["device"] = state.Device;
  root["rate_hz"] = state.Rate;
  root["dial"] = WordOf(DialWords, state.Dial);
  root["placement"] = AsJson(state.Placement);
  root["landmarks"] = AsJson(state.Landmarks);
  root["distances"] = AsJson(state.Distances);
  root["view"] = AsJson(state.View);
  return root;
}
} // namespace

std::string StudyText(const StudyState& state, const std::filesystem::path& folder,
                      const std::filesystem::path& file)
{
  try
  {
    return AsJson(state, folder).dump(2) + "\n";
  }
  catch (const OrderedJson::type_error&)
  {
    Refuse(file, "cannot be written: a name in it is no UTF-8 text",
           "rename the file or the structure");
  }
}

StudyState StudyFromText(const std::string& text, const std::filesystem::path& folder,
                         const std::filesystem::path& file)
{
  const nlohmann::json root = ParseJson(text, file, "mend it there, or open another session");
  return StudyReader(root, folder, file).Read();
}
} // namespace palpate
