// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/KelpieModule.h"

#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "behaviour/Constants.h"
#include "behaviour/PythonEnumerations.h"
#include "behaviour/views/PythonNames.h"
#include "behaviour/views/WorldFrame.h"
#include "robot/body/FieldDescription.h"

namespace kelpie::behaviour {
namespace {

// C++ cannot list an enum's names; each list is in the order of its enum.
constexpr const char* kEnums =
    "GOAL_BLUE, GOAL_YELLOW, BEACON_BLUE_ON_PINK, BEACON_PINK_ON_BLUE, BEACON_YELLOW_ON_PINK, \\\n"
    "    BEACON_PINK_ON_YELLOW = range(6)\n"
    "PINKS_OFF, PINKS_MAP, PINKS_LOCALISE = range(3)\n"
    "LAYER_PLAYER, LAYER_ROLE, LAYER_DECISION, LAYER_SKILL = range(4)\n"
    "WALK, WALK_FAST, WALK_TURNING, WALK_DRIBBLE, WALK_BACK, WALK_LOW, WALK_WEAK = range(7)\n"
    "AIM_JOINTS, AIM_DIRECTION, AIM_POINT = range(3)\n"
    "NOT_FALLEN, ON_FRONT, ON_BACK, ON_LEFT, ON_RIGHT = range(5)\n"
    "RED, BLUE = range(2)\n"
    "INITIAL, READY, SET, PLAYING, FINISHED = range(5)\n"
    "LINE, BORDER, FIELD = range(3)\n"
    "NECK_TILT, HEAD_PAN, HEAD_NOD, MOUTH = range(4)\n"
    // Bits of Command.leds, in the order of robot/openr/Ers7Primitives.h.
    "LED_HEAD_COLOUR, LED_HEAD_WHITE, LED_MODE_RED, LED_MODE_GREEN, LED_MODE_BLUE, \\\n"
    "    LED_WIRELESS = (1 << i for i in range(6))\n"
    "LED_FACE = tuple(1 << i for i in range(6, 20))\n"
    "LED_BACK_FRONT_COLOUR, LED_BACK_FRONT_WHITE, LED_BACK_MIDDLE_COLOUR, \\\n"
    "    LED_BACK_MIDDLE_WHITE, LED_BACK_REAR_COLOUR, LED_BACK_REAR_WHITE = \\\n"
    "    (1 << i for i in range(20, 26))\n"
    // Stands for an object that was not given. None would hide a function that forgot to answer.
    "ANEW = object()\n";
static_assert(kLandmarkKindCount == 6 && kPinkUseCount == 3 && kTraceLayerCount == 4 &&
                  kWalkKindCount == 7 && kHeadAimCount == 3 && kFallSideCount == 5,
              "kEnums must follow its enums");

// All names: those that registry.py lists, and the others.
std::string enumsText() { return std::string(kEnums) + kEnumerations; }

std::string number(double value) {
  const std::string text = numberText(value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

// "WalkRequest"; "Point2" for a point of any frame of reference.
template <class T>
std::string className() {
  const std::string name = schemaName<T>();
  return name.substr(name.find('/') + 1);
}

// Whether each call needs an object of its own; a default's is shared by all of them.
template <class T>
constexpr bool kMadeAnew = HasFields<T>::value || kIsSequence<T>;

template <class T>
std::string defaultText(const T& value, const char* unit) {
  if constexpr (kIsSequence<T>) {
    // In these structs all elements of an array have the same default.
    if (value.size() == 0) return "[]";
    return "[" + defaultText(value[0], unit) + "] * " + std::to_string(value.size());
  } else if constexpr (HasFields<T>::value) {
    return className<T>() + "()";
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "True" : "False";
  } else if constexpr (std::is_same_v<T, Angle>) {
    return number(value.deg());
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    return number(value.seconds());
  } else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
    return std::to_string(static_cast<std::uint32_t>(value));
  } else {
    return number(value * shownFactor(unit));
  }
}

// A value in Python's words: `Point2(x=3.0, y=4.0)`.
template <class T>
std::string valueText(const T& value, const char* unit) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if constexpr (kIsSequence<T>) {
    for (const auto& item : value) add(valueText(item, unit));
    return "[" + text + "]";
  } else if constexpr (HasFields<T>::value) {
    forEachField(value, [&](const auto& f, const auto& member) {
      using Member = std::decay_t<decltype(member)>;
      add(pythonName<Member>(f.name, f.unit) + "=" + valueText(member, f.unit));
    });
    return className<T>() + "(" + text + ")";
  } else {
    return defaultText(value, unit);
  }
}

// The shipped fields, so that tests of behaviours play on what the robot knows.
std::string fieldsText() {
  std::string text = "\n\nFIELDS = {\n";
  for (const char* name : {"2006", "osaka2005", "2004"})
    text +=
        std::string("    '") + name + "': " + valueText(*body::fieldDescription(name), "") + ",\n";
  return text + "}\n";
}

// Every member is a parameter of its own: a wrong name raises an error at once, otherwise nobody
// would notice that the request is lost, and a call costs half of one that takes names in a dict.
class ClassWriter {
 public:
  template <class T>
  void write() {
    if (!done_.insert(className<T>()).second) return;
    writeParts<T>();
    std::string names, parameters, setters;
    const T sample{};
    forEachField(sample, [&](const auto& f, const auto& member) {
      using Member = std::decay_t<decltype(member)>;
      if (std::is_same_v<Member, Fallback>) return;
      const std::string name = pythonName<Member>(f.name, f.unit);
      names += "        '" + name + "',\n";
      const std::string made = defaultText(member, f.unit);
      parameters += ",\n                 " + name + "=" + (kMadeAnew<Member> ? "ANEW" : made);
      setters += "        self." + name + " = " +
                 (kMadeAnew<Member> ? made + " if " + name + " is ANEW else " : "") + name + "\n";
    });
    text_ << "\n\nclass " << className<T>() << ":\n    __slots__ = (\n"
          << names << "    )\n\n    def __init__(self, *" << parameters << "):\n"
          << setters;
  }

  void line(const char* statement) { text_ << "\n\n" << statement << "\n"; }

  std::string text() const { return text_.str(); }

 private:
  template <class T>
  void writeParts() {
    const T sample{};
    forEachField(sample, [&](const auto&, const auto& member) {
      using Part = typename ScalarOf<std::decay_t<decltype(member)>>::type;
      // A trace is a list of tuples: they are made in every frame, and faster than objects.
      if constexpr (HasFields<Part>::value && !std::is_same_v<Part, TraceStep>) write<Part>();
    });
  }

  std::ostringstream text_;
  std::set<std::string> done_;
};

// What behaviours need when they are loaded; the world's classes come behind it.
std::string loadedText(ClassWriter& writer) {
  writer.write<Constants>();
  writer.line("constants = Constants()");
  writer.write<Command>();
  return writer.text();
}

}  // namespace

std::string kelpieModuleText() {
  ClassWriter writer;
  return enumsText() + loadedText(writer);
}

std::string kelpieStandInText() {
  ClassWriter writer;
  loadedText(writer);
  writer.write<WorldFrame>();
  return std::string(
             "# SPDX-License-Identifier: Apache-2.0\n"
             "# Stands in for the host's module `kelpie` under a plain python3. Written from the "
             "field\n"
             "# lists by behaviour_names when the tree is built.\n") +
         enumsText() + writer.text() + fieldsText();
}

}  // namespace kelpie::behaviour
