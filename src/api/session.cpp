// SPDX-License-Identifier: Apache-2.0
#include "api/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <thread>

#include "api/camera_view.h"
#include "api/film_picture.h"
#include "api/request.h"
#include "cpu/kernel.h"
#include "cpu/render_cpu.h"
#include "util/threads.h"
#include "util/timer.h"

namespace snell {

namespace {

// A coarse picture is that many times smaller, so that it takes about as long as an eye takes for movement.
constexpr int LeastCoarseness = 2;
constexpr int MostCoarseness = 16;
constexpr double TooSlow = 0.1;  // seconds
constexpr double FastEnough = 0.015;

// Only what a session renders.
RenderOptions SessionOptions(RenderOptions options) {
  options.crop.reset();
  options.samples.reset();
  options.aovs = std::vector<std::string>{};
  options.denoiser = Denoiser::None;
  options.seconds.reset();
  options.noise.reset();
  options.film = {};
  return options;
}

render::RenderRequest OfSize(render::RenderRequest request, int width, int height) {
  request.settings.width = width;
  request.settings.height = height;
  request.rect = {0, 0, width, height};
  return request;
}

}  // namespace

// What is shared is guarded by the mutex; the film and the passes belong to the thread.
class RenderSession::Worker {
 public:
  Worker(const Scene& scene, const RenderOptions& options)
      : scene_(scene), options_(SessionOptions(options)), limit_(options.threads) {
    request_ = RequestOf(scene_.contents(), options_).first;
    options_.width = request_.settings.width;
    options_.height = request_.settings.height;
    render::Film film({0, 0, 1, 1});
    render::Statistics statistics;
    prepared_ = std::make_unique<cpu::PreparedScene>(scene_.contents(), request_, film, nullptr,
                                                     statistics);
    thread_ = std::thread([this] { Work(); });
  }

  ~Worker() {
    Change([&] { ends_ = true; });
    thread_.join();
  }

  std::uint64_t SetView(const CameraView& view) {
    return Edit([&](RenderOptions& options) { options.cameraView = view; });
  }

  void SetSize(int width, int height) {
    Edit([&](RenderOptions& options) { options.width = width, options.height = height; });
  }

  void SetPaused(bool paused) {
    Change([&] { paused_ = paused; });
  }

  std::optional<SessionPicture> Snapshot() {
    const std::lock_guard lock(mutex_);
    std::optional<SessionPicture> picture;
    picture.swap(newest_);
    return picture;
  }

  std::string Fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
  }

  render::RenderRequest Request() const {
    const std::lock_guard lock(mutex_);
    return request_;
  }

  std::optional<std::array<double, 3>> PointAt(double x, double y) const {
    const std::lock_guard lock(sceneMutex_);
    cpu::Kernel kernel = cpu::BindKernel(prepared_->flat(), prepared_->bvh());
    const kernel::Camera& camera = kernel.params.camera;
    const kernel::vec2 pixel(float(x) * float(camera.resolution.x),
                             float(y) * float(camera.resolution.y));
    const kernel::CameraRay start = kernel.CameraRayAt(pixel, kernel::vec2(0.5f), 0);
    if (!(start.weight > 0)) return std::nullopt;
    const bvh::Intersection found = prepared_->bvh().Closest(
        start.ray, std::numeric_limits<float>::infinity(), kernel::MASK_CAMERA);
    if (found.primitive == kernel::None) return std::nullopt;
    const kernel::vec3 p = start.ray.o + start.ray.d * found.t;
    return std::array<double, 3>{double(p.x), double(p.y), double(p.z)};
  }

 private:
  // Begin anew with other options.
  template <class Set>
  std::uint64_t Edit(Set set) {
    const std::lock_guard one(editMutex_);
    RenderOptions options = options_;
    set(options);
    render::RenderRequest request = RequestOf(scene_.contents(), options).first;
    options_ = std::move(options);
    std::uint64_t number = 0;
    Change([&] {
      request_ = std::move(request);
      number = ++view_;
    });
    return number;
  }

  // Let the thread see something new.
  template <class Set>
  void Change(Set set) {
    {
      const std::lock_guard lock(mutex_);
      set();
      if (stop_) stop_->Raise();
    }
    changed_.notify_all();
  }

  // What is to be rendered, for the thread alone.
  struct Task {
    render::RenderRequest request;
    std::uint64_t view = 0;
  };

  // Wait until there is something to do. None: the session ends.
  std::optional<Task> NextTask() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock,
                  [&] { return ends_ || (!paused_ && (!film_ || view_ != shown_ || !done_)); });
    if (ends_) return std::nullopt;
    return Task{request_, view_};
  }

  void Work() {
    try {
      while (const std::optional<Task> task = NextTask()) {
        const bool isNew = !film_ || task->view != shown_;
        if (!isNew || Begin(*task)) Pass(*task);
      }
    } catch (const std::bad_alloc&) {
      SetFault("there is not enough memory for this picture");
    } catch (const std::exception& error) {
      SetFault(error.what());
    }
  }

  void SetFault(const std::string& fault) {
    const std::lock_guard lock(mutex_);
    fault_ = fault;
  }

  // Show a new view coarsely, and prepare for its passes. False: something else is wanted first.
  bool Begin(const Task& task) {
    // Each picture is twice as fine as the one before. The first one is finished even if the view changes, so that there
    // is something to see while it moves
    const int first = coarseness_;
    for (int coarseness = first; coarseness >= LeastCoarseness; coarseness /= 2) {
      const Timer timer;
      const bool isFirst = coarseness == first;
      if (!ShowCoarsely(task, coarseness, isFirst)) return false;
      const double seconds = timer.Seconds();
      if (isFirst && seconds > TooSlow) coarseness_ = std::min(2 * first, MostCoarseness);
      if (isFirst && seconds < FastEnough) coarseness_ = std::max(first / 2, LeastCoarseness);
    }

    SetCamera(task.request);
    film_.emplace(task.request.rect);
    shown_ = task.view;
    samples_ = 0;
    done_ = false;
    return true;
  }

  bool ShowCoarsely(const Task& task, int coarseness, bool isFirst) {
    const scene::RenderSettings& settings = task.request.settings;
    const auto smaller = [&](int size) {
      return std::max(1, (size + coarseness / 2) / coarseness);
    };
    render::RenderRequest coarse =
        OfSize(task.request, smaller(settings.width), smaller(settings.height));
    coarse.lastSample = 1;
    SetCamera(coarse);
    render::Film film(coarse.rect);
    const auto over = [&] { return ends_ || paused_ || (!isFirst && view_ != task.view); };
    if (!Render(coarse, film, over)) return false;
    Publish(film, task.view, 0, false);
    return true;
  }

  // Give each pixel one more sample, or stop when something changes.
  void Pass(const Task& task) {
    render::RenderRequest pass = task.request;
    pass.lastSample = std::uint32_t(samples_ + 1);
    const bool whole = Render(pass, *film_, [&] { return ends_ || paused_ || view_ != task.view; });
    if (!whole) return;
    ++samples_;
    done_ = samples_ >= int(task.request.lastSample);
    Publish(*film_, task.view, samples_, done_);
  }

  // While one lives, a pass is running; faults end it, too.
  class Running {
   public:
    explicit Running(Worker& worker) : worker_(worker) {}
    ~Running() {
      const std::lock_guard lock(worker_.mutex_);
      worker_.stop_ = nullptr;
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

   private:
    Worker& worker_;
  };

  // Render until `over`, which is asked when something changes. Returns whether it came to the end.
  template <class Over>
  bool Render(const render::RenderRequest& request, render::Film& film, Over over) {
    for (;;) {
      StopFlag stop;
      {
        const std::lock_guard lock(mutex_);
        if (over()) return false;
        stop_ = &stop;
      }
      const Running running(*this);
      render::Statistics statistics;
      cpu::RenderPrepared(scene_.contents(), *prepared_, request, film, nullptr, &stop, statistics);
      if (statistics.end == render::End::Samples) return true;
    }
  }

  void SetCamera(const render::RenderRequest& request) {
    const std::lock_guard lock(sceneMutex_);
    prepared_->SetCamera(request.camera, request.settings);
  }

  // Hand out a picture. One that nobody has taken may stand for one that is a pass newer, but not for the last one.
  void Publish(const render::Film& film, std::uint64_t view, int samples, bool finished) {
    {
      const std::lock_guard lock(mutex_);
      if (newest_ && newest_->view == view && newest_->samples > 0 && !finished) return;
    }
    SessionPicture picture{PictureOf(film), samples, view, finished};
    const std::lock_guard lock(mutex_);
    newest_ = std::move(picture);
  }

  const Scene scene_;
  std::mutex editMutex_;
  RenderOptions options_;  // of the newest request
  const ThreadLimit limit_;
  render::RenderRequest request_;
  std::unique_ptr<cpu::PreparedScene> prepared_;
  mutable std::mutex
      sceneMutex_;  // of the prepared scene's camera, beside the thread's own reading

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t view_ = 0;
  bool paused_ = false;
  bool ends_ = false;
  StopFlag* stop_ = nullptr;  // of the pass that is running
  std::optional<SessionPicture> newest_;
  std::string fault_;

  // The thread's
  int coarseness_ = 4;
  std::optional<render::Film> film_;
  std::uint64_t shown_ = 0;  // the view that is in the film
  int samples_ = 0;
  bool done_ = false;
  std::thread thread_;
};

RenderSession::RenderSession(const Scene& scene, const RenderOptions& options)
    : worker_(std::make_unique<Worker>(scene, options)) {}
RenderSession::~RenderSession() = default;

CameraView RenderSession::view() const {
  const render::RenderRequest request = worker_->Request();
  return ViewOfCamera(request.camera, request.settings.width, request.settings.height);
}
std::uint64_t RenderSession::SetView(const CameraView& view) { return worker_->SetView(view); }
void RenderSession::SetSize(int width, int height) { worker_->SetSize(width, height); }
void RenderSession::SetPaused(bool paused) { worker_->SetPaused(paused); }
std::optional<SessionPicture> RenderSession::Snapshot() { return worker_->Snapshot(); }
std::string RenderSession::fault() const { return worker_->Fault(); }
std::optional<std::array<double, 3>> RenderSession::PointAt(double x, double y) const {
  return worker_->PointAt(x, y);
}
int RenderSession::width() const { return worker_->Request().settings.width; }
int RenderSession::height() const { return worker_->Request().settings.height; }
int RenderSession::spp() const { return worker_->Request().settings.spp; }
std::string RenderSession::integrator() const {
  return worker_->Request().settings.integrator == scene::Integrator::Path ? "path" : "whitted";
}

}  // namespace snell
