#pragma once
// Mass-spring proxies as a voice of many bodies, which share a budget of computing time. It locks nothing, but it
// allocates: played live, it goes into a BufferedVoice.

#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/body_track.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/voices/arrivals.hpp"
#include "idiophone/instruments/voices/body_ears.hpp"
#include "idiophone/instruments/voices/falling_piece.hpp"
#include "idiophone/instruments/voices/moving_points.hpp"
#include "idiophone/instruments/voices/proxy_film.hpp"
#include "idiophone/instruments/voices/shared_budget.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

/// A force on a body of an engine. @param body  its number there
[[nodiscard]] proxies::Force proxy_force(std::size_t body, const resonators::PointForce& force);

/// A body of an engine.
struct ProxyBody {
  std::string name;
  Vector3 centre = Vector3::Zero();  ///< of mass, undeformed, m
  drivers::BodyTrack track{};        ///< how it moves; empty: it stays where it is
};

/// How proxies are heard.
struct ProxyHearing {
  proxies::Sound sound = proxies::Sound::pressure;          ///< as the engine has it
  double speed_of_sound = 343.0;                            ///< m/s
  int rate = 44100;                                         ///< audio samples per second
  double budget = std::numeric_limits<double>::infinity();  ///< processor time per time of sound, at first
  double speed = usual_speed;                               ///< springs that one core computes in a second
  std::size_t most_active = 8;                              ///< proxies that may sound at once, at first
  std::shared_ptr<SharedBudget> shared{};                   ///< with sound maps, if there are any
};

/// Each body sounds from its centre of mass: its sound arrives at each receiver after its way through the air, and is
/// the weaker the longer the way. Bodies and receivers that move shift the pitch (Doppler). The deviation is heard as
/// it is, wherever body and listener are.
class ProxyVoices : public Voice {
 public:
  /// @param engine    has the bodies
  /// @param audience  a head hears each body, and its pieces with it, from the direction of the body
  /// @throws std::runtime_error when the sound of a body takes longer than longest_way
  ProxyVoices(proxies::Engine engine, std::vector<ProxyBody> bodies, const Audience& audience,
              const ProxyHearing& hearing);

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return names_; }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t body) const override { return bodies_[body].centre; }
  void require_tunable(std::size_t body, const score::Tuning& tuning) const override;
  void require_in_reach(const Vector3& place) const override;
  void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) override;
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) override;
  void set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) override;
  void set_budget(double budget, std::int64_t start) override;
  void hear_at(const ListenerPlace& place) override;
  [[nodiscard]] std::int64_t lead() const override { return engine_.delay(); }
  void render(std::span<double> sound, std::int64_t clock) override;

  /// A body joins, at rest, heard from where it is. @return its number, as proxies::Engine::add()
  /// @throws std::invalid_argument as proxies::Engine::add(); std::runtime_error when a head hears the voices
  std::size_t add(proxies::BodyOptions options, ProxyBody body);

  /// As proxies::Engine::remove(). What it has emitted still arrives.
  void remove(std::size_t body) { engine_.remove(body); }

  /// The track of a body has put it somewhere else at once: the engine learns now where its listener is.
  void jump(std::size_t body);

  /// Whether a body is computed: it sounds or fades.
  [[nodiscard]] bool sounds(std::size_t body) const { return engine_.sounds(body); }

  /// What the bodies that sound take of the budget, [bodies that sound], with costs as SharedBudget has them.
  [[nodiscard]] std::vector<Claim> claims() const;

  /// Of a body, or of the piece of one.
  [[nodiscard]] const std::string& name_of(std::size_t body) const { return bodies_[body].name; }

  /// The bodies that broke. Not while another thread renders.
  [[nodiscard]] const std::vector<proxies::Fracture>& fractures() const { return fractures_; }

  /// Before the first sample: takes a film. The bodies have one level. @param frames_per_second  above 0
  void take_film(double frames_per_second);

  /// Before the first sample: what pieces fall on. Without it they fly on for ever.
  void fall_on(const Ground& ground) { ground_ = ground; }

  /// The film so far, if one is taken. Not while another thread renders.
  [[nodiscard]] const std::optional<ProxyFilm>& film() const { return film_; }

  /// What the engine chose since the last call. Not while another thread renders.
  [[nodiscard]] std::vector<proxies::Choice> take_choices() { return engine_.take_choices(); }

 private:
  struct Change {
    std::int64_t start;
    std::size_t body;
    score::Detail detail;
  };
  void make_due_changes();
  void share_budget();
  void change(std::size_t body, const score::Detail& detail);
  /// How a body moves in the room.
  struct Movement {
    Eigen::Isometry3d pose;  ///< from the coordinates of the body
    Vector3 centre;          ///< m
    Vector3 velocity;        ///< of the centre, m/s
    Vector3 spin;            ///< rad/s
  };
  void add_pieces(const proxies::Fracture& fracture);
  [[nodiscard]] Movement movement(std::size_t body, double time) const;
  void let_fall(const proxies::Piece& piece, const Movement& whole, double time);
  void add_landings(std::size_t samples);
  [[nodiscard]] Eigen::Isometry3d pose(std::size_t body, std::int64_t sample) const;
  [[nodiscard]] Vector3 place(std::size_t body, std::int64_t sample) const;
  void film_if_due();
  void move_listener(std::size_t body, const Vector3& middle, std::int64_t sample);
  [[nodiscard]] Vector3 middle_of_points(std::int64_t sample) const;
  void move_listeners();
  void turn_ears();
  void advance(std::size_t samples);
  void take_fractures();
  void emit(std::size_t samples);
  void take(std::span<double> sound);
  void take_with_ears(std::span<double> sound);
  void add_as_it_is(std::span<double> sound);

  proxies::Engine engine_;
  std::vector<ProxyBody> bodies_;
  std::vector<std::size_t> roots_;  // [bodies] that itself, or of which it is a piece
  std::vector<std::string> names_;
  std::size_t channels_;
  ProxyHearing hearing_;
  Audience audience_;
  std::deque<Change> changes_;  // that are not due, by their start
  std::vector<proxies::Fracture> fractures_;
  std::optional<ProxyFilm> film_;
  Ground ground_;
  std::map<std::size_t, std::shared_ptr<FallingPiece>> falling_;  // by the number of the piece
  MovingPoints points_;                                           // of the audience
  std::vector<Arrivals> arrivals_;                                // [points]; none with a head
  std::vector<BodyEars> ears_;                                    // [bodies without pieces] of a head
  std::vector<double> each_;                                      // [bodies x samples] at 1 m
  std::int64_t now_ = 0;  // audio sample that is heard next; the engine is ahead by its delay
};

}  // namespace idiophone::voices
