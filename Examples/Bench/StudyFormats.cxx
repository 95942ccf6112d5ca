// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "Contest.h"
#include "DepthPainter.h"
#include "RayOracle.h"
#include "Sun.h"

#include "vtkShadowLight.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace NBufferBench
{
namespace
{
using NBufferPeers::DepthPainter;
using NBufferPeers::DepthVertex;
using NBufferPeers::DepthView;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFormat;
using NBufferStudy::DepthFrame;
using NBufferStudy::DepthPlanes;

constexpr int Step = 8;          ///< Every so many pixels along each axis are compared with rays.
constexpr int Lexels = 256;      ///< Of a litmap along each axis, as the default has them.
constexpr double Bias = 0.1;     ///< In metres along the ray of the light.
constexpr double Farther = 1e-3; ///< In metres: by how much a wrong surface is farther.

/// What rays in double precision say about a pixel.
struct Sample
{
  std::size_t Pixel;
  glm::dvec3 Ray; ///< From the eye, with unit length.
  Oracle::Receiver Receiver;
  glm::dvec3 Position;
  bool Faces = false; ///< Whether its surface faces the light.
  bool Shadowed = false;
  std::pair<int, int> Lexel;
};

/// The scene as it is drawn in other formats, and as rays find it.
class DrawnScene
{
public:
  DrawnScene(Session& session, const NBufferExamples::CameraPose& pose)
    : Frame(CollectFrames(session, { pose }).front())
    , Tracer(Prepare(session, pose))
    , Sun(NBufferExamples::MakeSun({}))
    , Light(this->Sun)
    , Window(vtkOpenGLRenderWindow::SafeDownCast(session.GetWindow()))
    , Painter(this->Window)
  {
    this->Eye = glm::make_vec3(this->Tracer.GetEyeRay(0, 0).Origin);
    const vtkNBufferProjection::Rows& rows = this->Frame.Projection.GetWorldToClip();
    this->View = { this->Frame.Width, this->Frame.Height, {}, glm::dvec3(rows[0]),
      glm::dvec3(rows[1]), glm::dvec3(rows[3]) };
    std::map<vtkProp*, int> places;
    for (vtkProp* prop : session.GetProps())
    {
      places.emplace(prop, static_cast<int>(places.size()));
    }
    const RenderedTriangles& triangles = this->Tracer.GetTriangles();
    for (const int owner : triangles.Owners)
    {
      this->Props.push_back(places.at(triangles.Actors[owner].Prop));
    }
    std::vector<DepthVertex> vertices;
    for (std::size_t i = 0; i < triangles.Corners.size(); i += 3)
    {
      vertices.push_back({ glm::vec3(glm::make_vec3(&triangles.Corners[i]) - this->Eye),
        static_cast<float>(1 + i / 9) });
    }
    this->Window->MakeCurrent();
    this->Painter.SetTriangles(vertices);
    this->MakeSamples();
  }

  /// Draws the scene and measures. The result has a member `skipped` if the device cannot.
  Json::Value Measure(const DepthFormat& format, const DepthPlanes& planes)
  {
    Json::Value entry;
    entry["format"] = format.GetName();
    this->View.Planes = planes;
    std::string why;
    if (!this->Painter.SetView(format, this->View, why))
    {
      entry["skipped"] = why;
      return entry;
    }
    this->Painter.Draw(0, static_cast<int>(3 * this->Props.size()));
    const std::vector<float> numbers = this->Painter.ReadNumbers();
    const std::vector<double> depth = this->Painter.ReadDepth();
    this->TestBoxes(format, planes, numbers, depth, entry);
    this->TestReceivers(format, planes, numbers, depth, entry);
    return entry;
  }

private:
  static vtkRenderer* Prepare(Session& session, const NBufferExamples::CameraPose& pose)
  {
    session.SetPose(pose);
    return session.GetRenderer();
  }

  glm::dvec3 GetDirectionToLight() const { return -glm::make_vec3(this->Light.Direction); }

  void MakeSamples()
  {
    vtkShadowLight light;
    light.Direction = -this->GetDirectionToLight();
    const vtkShadowLightSpace space(light);
    this->U = space.GetU();
    this->V = space.GetV();
    this->Low = glm::dvec2(1e300);
    glm::dvec2 high(-1e300);
    for (int y = Step / 2; y < this->Frame.Height; y += Step)
    {
      for (int x = Step / 2; x < this->Frame.Width; x += Step)
      {
        Sample sample;
        if (this->Tracer.GetReceiver(x, y, 0.0, 0.0, sample.Receiver))
        {
          sample.Pixel = static_cast<std::size_t>(y) * this->Frame.Width + x;
          sample.Ray = glm::make_vec3(this->Tracer.GetEyeRay(x, y).Direction);
          sample.Position = glm::make_vec3(sample.Receiver.Position);
          sample.Faces =
            glm::dot(glm::make_vec3(sample.Receiver.Normal), this->GetDirectionToLight()) > 0.02;
          sample.Shadowed = this->Tracer.IsShadowed(sample.Receiver, this->Light);
          const glm::dvec2 place = this->ToLight(sample.Position);
          this->Low = glm::min(this->Low, place);
          high = glm::max(high, place);
          this->Samples.push_back(sample);
        }
      }
    }
    this->Side = (high - this->Low) / static_cast<double>(Lexels);
    for (Sample& sample : this->Samples)
    {
      sample.Lexel = this->GetLexel(sample.Position);
    }
  }

  glm::dvec2 ToLight(const glm::dvec3& position) const
  {
    return { glm::dot(position, this->U), glm::dot(position, this->V) };
  }

  std::pair<int, int> GetLexel(const glm::dvec3& position) const
  {
    const glm::dvec2 lexel = (this->ToLight(position) - this->Low) / this->Side;
    return { static_cast<int>(std::floor(lexel.x)), static_cast<int>(std::floor(lexel.y)) };
  }

  /// Returns whether anything is on the way to the light, beyond the bias.
  bool IsShadowed(const glm::dvec3& position) const
  {
    const glm::dvec3 direction = this->GetDirectionToLight();
    Ray ray;
    std::copy_n(glm::value_ptr(position), 3, ray.Origin);
    std::copy_n(glm::value_ptr(direction), 3, ray.Direction);
    ray.Near = Bias;
    bool found = false;
    this->Tracer.GetTree().VisitCrossings(ray,
      [&](int, double)
      {
        found = true;
        return false;
      });
    return found;
  }

  /// Returns where the ray from a position to the light leaves the sample's own surface, or 0.
  double GetBias(const glm::dvec3& position, const Sample& sample) const
  {
    const glm::dvec3 normal = glm::make_vec3(sample.Receiver.Normal);
    return std::max(glm::dot(sample.Position - position, normal), 0.0) /
      glm::dot(normal, this->GetDirectionToLight());
  }

  /// Tests the boxes against an N-buffer of the depth. Visible are the props of this very image.
  void TestBoxes(const DepthFormat& format, const DepthPlanes& planes,
    const std::vector<float>& numbers, const std::vector<double>& depth, Json::Value& entry) const
  {
    std::set<int> visible;
    for (const float number : numbers)
    {
      if (number > 0.0f)
      {
        visible.insert(this->Props[static_cast<std::size_t>(number) - 1]);
      }
    }
    std::vector<DepthFrame> frames = { NBufferStudy::MakeFrame(
      this->Frame, format, planes, depth) };
    for (DepthBox& box : frames.front().Boxes)
    {
      box.Visible = visible.count(box.Prop) > 0;
    }
    std::vector<NBufferStudy::ContenderPointer> contenders;
    contenders.push_back(NBufferStudy::MakeFamilyContender(NBufferStudy::DepthFamily()));
    const NBufferStudy::ContestResult result =
      NBufferStudy::RunContest(frames, contenders, 0, nullptr).front();
    entry["boxes"] = static_cast<Json::Int64>(result.Boxes);
    entry["hidden"] = static_cast<Json::Int64>(result.Hidden);
    entry["false_visible"] = static_cast<Json::Int64>(result.FalseVisible);
    entry["false_hidden"] = static_cast<Json::Int64>(result.FalseHidden);
    entry["slack"] = Summarize(NBufferStudy::GetSlacks(frames.front(), format, planes));
  }

  /// Reconstructs positions from the depth, and compares them with those of rays.
  void TestReceivers(const DepthFormat& format, const DepthPlanes& planes,
    const std::vector<float>& numbers, const std::vector<double>& depth, Json::Value& entry) const
  {
    int wrong = 0;
    int lost = 0;
    int compared = 0;
    int displaced = 0;
    int facing = 0;
    int shadows = 0;
    std::vector<double> errors;
    std::vector<double> biases;
    std::set<std::pair<int, int>> lexels;
    std::set<std::pair<int, int>> found;
    for (const Sample& sample : this->Samples)
    {
      lexels.insert(sample.Lexel);
      const int shown = static_cast<int>(numbers[sample.Pixel]) - 1;
      wrong += this->IsFarther(shown, sample) ? 1 : 0;
      const double stored = depth[sample.Pixel];
      if (stored == format.GetBackground())
      {
        ++lost;
        continue;
      }
      const double w = format.GetDistance(planes, stored) / glm::dot(this->View.W, sample.Ray);
      const glm::dvec3 position = this->Eye + w * sample.Ray;
      found.insert(this->GetLexel(position));
      if (shown != sample.Receiver.Triangle)
      {
        continue;
      }
      ++compared;
      errors.push_back(glm::distance(position, sample.Position));
      displaced += this->GetLexel(position) != sample.Lexel ? 1 : 0;
      if (sample.Faces)
      {
        ++facing;
        shadows += this->IsShadowed(position) != sample.Shadowed ? 1 : 0;
        biases.push_back(this->GetBias(position, sample));
      }
    }
    const auto lostLexels = std::count_if(lexels.begin(), lexels.end(),
      [&](const std::pair<int, int>& lexel) { return found.count(lexel) == 0; });
    entry["samples"] = static_cast<int>(this->Samples.size());
    entry["wrong"] = wrong;
    entry["lost"] = lost;
    entry["compared"] = compared;
    entry["displaced"] = displaced;
    entry["lexels"] = static_cast<int>(lexels.size());
    entry["lost_lexels"] = static_cast<int>(lostLexels);
    entry["facing"] = facing;
    entry["wrong_shadows"] = shadows;
    if (!errors.empty())
    {
      entry["median_error"] = GetQuantile(errors, 0.5);
      entry["most_error"] = *std::max_element(errors.begin(), errors.end());
      entry["bias"] = GetQuantile(biases, 0.99);
    }
  }

  /// Returns whether the pixel shows something that is farther than what the ray meets first.
  bool IsFarther(int triangle, const Sample& sample) const
  {
    if (triangle < 0 || triangle == sample.Receiver.Triangle)
    {
      return triangle < 0;
    }
    const double* corners =
      &this->Tracer.GetTriangles().Corners[9 * static_cast<std::size_t>(triangle)];
    const glm::dvec3 a = glm::make_vec3(corners);
    const glm::dvec3 normal =
      glm::cross(glm::make_vec3(corners + 3) - a, glm::make_vec3(corners + 6) - a);
    const double distance = glm::dot(normal, a - this->Eye) / glm::dot(normal, sample.Ray);
    return distance > glm::distance(this->Eye, sample.Position) + Farther;
  }

  DepthFrame Frame;
  Oracle Tracer;
  vtkSmartPointer<vtkLight> Sun;
  OracleLight Light;
  vtkOpenGLRenderWindow* Window;
  DepthPainter Painter;
  DepthView View{};
  glm::dvec3 Eye{};
  std::vector<int> Props; ///< By triangle, the place of its prop in the scene's list.
  std::vector<Sample> Samples;
  glm::dvec3 U{};
  glm::dvec3 V{};
  glm::dvec2 Low{};
  glm::dvec2 Side{}; ///< Of a lexel.
};
}

Json::Value MeasureFormats(
  Session& session, const NBufferExamples::CameraPose& pose, double largestRatio)
{
  Json::Value entries(Json::arrayValue);
  DrawnScene scene(session, pose);
  for (double ratio = pose.Far / pose.Near; ratio < 1.5 * largestRatio; ratio *= 10.0)
  {
    for (const DepthFormat& format : NBufferStudy::GetDepthFormats())
    {
      ShowProgress("the scene in depth of " + format.GetName());
      Json::Value entry = scene.Measure(format, { pose.Far / ratio, pose.Far });
      entry["ratio"] = Round(ratio);
      entries.append(entry);
    }
  }
  return entries;
}

} // namespace NBufferBench
