#pragma once
// SPDX-License-Identifier: Apache-2.0
// AppModel: what all parts of the window share: the show that is open, the newest news of the engine, what is
// selected, and what is asked for. Parts change it through its functions and hear of it through its signals;
// they do not know each other. Every change of the look can be undone. Window thread.

#include "diagnose/diagnosis.h"
#include "link/link.h"
#include "ui/model/camera_flight.h"
#include "ui/model/jobs.h"
#include "ui/model/look_fader.h"

#include <QObject>
#include <QSize>
#include <QUndoStack>

#include <set>
#include <string>

namespace ghost::ui {

class AppModel : public QObject {
    Q_OBJECT
public:
    static constexpr int kTravel_ms = 900;

    // Sets Link::on_news.
    explicit AppModel(Link& link);

    Link& link() { return link_; }
    // What the engine said last.
    const std::shared_ptr<const scene::Show>& show() const { return opened_.show; } // null: none is open
    const Opened& opened() const { return opened_; }
    // Whether the newest edit is shown here and not yet by the engine, which reads the show for it.
    bool is_taking_edit() const { return request_.text && request_.text != opened_.text; }
    const Picture& picture() const { return picture_; }
    const RigNow& rig() const { return rig_; }
    // Of the recording, what the window shows or, after a jump that the engine has not taken yet, is about to
    // show. rig().at_s is what it shows.
    double moment_s() const;
    // Whether the news are of that moment.
    bool has_jumped() const { return rig_.seeks == request_.transport.seeks; }
    const dmx::Statistics& network() const { return network_; }
    // What is wrong with it, for the show that is open.
    std::vector<scene::Sentence> diagnosis() const { return scene::diagnose(network_, patch_); }
    const scene::PatchMap& patch() const { return patch_; }
    const Explained& explained() const { return explained_; }
    // The fixture that the mouse rests on; nothing: none, or it comes.
    const std::optional<Explained>& hovered() const { return hovered_; }
    void hover(std::optional<std::size_t> fixture);
    // Of all fixtures; empty: nobody wants them, or they come. Some seconds old.
    const std::vector<Verdict>& verdicts() const { return verdicts_; }
    const std::vector<Message>& messages() const { return messages_; }
    const std::string& activity() const { return activity_; }
    const BounceNow& bounce() const { return bounce_; }
    const UnseenStage& unseen_stage() const { return unseen_stage_; }
    const RdmNow& rdm() const { return rdm_; }
    const std::vector<float>& waveform() const { return waveform_; } // of the recording; empty: not known
    const std::optional<Probed>& probed() const { return probed_; }  // of the place that is asked for
    const Recorded& recorded() const { return recorded_; }           // the last one
    const std::vector<NamedPicture>& camera_pictures() const { return camera_pictures_; }
    std::uint64_t saved() const { return saved_; } // number of the picture that was saved last
    // Came from the network and may be taken; number 0: none yet.
    const ReceivedPlot& plot() const { return plot_; }

    // What is asked for.
    const ViewRequest& request() const { return request_; }
    // As it is meant; while it fades, the request has one on the way there.
    const Look& look() const { return look_; }
    const scene::Camera& camera() const { return request_.camera; }
    // What is seen, as a camera of its own: its size is that of the frame, or of the view where there is
    // none, and it stands where the mover that carries the camera has it now.
    scene::Camera seen_camera() const;
    // Likewise, with the size of the request: what a hand or a flight goes on from.
    scene::Camera camera_to_move() const;
    // The show's camera that stands there, by index; nothing: a free one.
    std::optional<std::size_t> stored_camera() const;
    // Nothing happens where it is open or being opened; one that could not be is tried again.
    void open(const std::string& show);
    // One that was made of the plot that is open as it is: what hands hold and what is selected stay.
    void open_made_of_plot(const std::string& show);
    // A copy of the one that is open: camera, input and undo list stay, too, and the recording goes on.
    void open_copy(const std::string& show);
    bool is_opening() const { return answered_opens_ < request_.opens; }
    bool is_opening_copy() const { return is_opening() && copy_ == request_.opens; }
    // Why the one that was asked for last is not open; the one before may still be.
    const std::optional<Error>& open_error() const { return open_error_; }
    // Asks what is met first on that way; picked_came says it, most often within a frame. Returns the number
    // of the request: a newer one takes its place. beside: Pick.
    std::uint64_t pick(const glm::vec3& from_m, const glm::vec3& way, float beside = 0);
    const Picked& picked() const { return picked_; }
    // Ends a travel.
    void set_camera(const scene::Camera& camera);
    // Likewise, with the frame that camera has of its own.
    void cut_to(const scene::Camera& stored);
    // To browsers, and to the engine, which draws small pictures of them.
    void publish_looks(LooksNow looks);
    void publish_cue(const std::string& name); // that was called last; "": none
    // Pixels of the picture.
    void set_size(int width, int height);
    // Of a second window, empty: there is none. The picture is drawn for the larger of the two.
    void set_second_size(const QSize& size);
    // What the window spends on a picture: its news, and painting it.
    const dmx::Latency& window_cost() const { return window_cost_; }
    void count_window(std::chrono::nanoseconds cost);
    // Both counts begin anew.
    void reset_figures();
    // Smoothly, in about a second if nothing else is said.
    void travel_to(const scene::Camera& camera, int travel_ms = kTravel_ms);
    // Likewise, to the frame that camera has of its own.
    void travel_to_stored(const scene::Camera& stored, int travel_ms = kTravel_ms);
    // Likewise: the ball fills the frame.
    void look_at(const glm::vec3& centre_m, float radius_m);
    bool travels() const { return flight_.is_going(); }
    // Of the camera as it is and, while it travels, of both ends.
    void set_exposure(float ev100, bool automatic);
    // Changes nobody undoes: anything but the look.
    template <class F>
    void change_request(F&& f) {
        f(request_);
        send();
    }
    // text: what was done, for the undo list. Changes of one kind that follow each other closely, as those of
    // a slider, are one step; kind 0: always a step of its own.
    void set_look(Look look, const QString& text, int kind = 0);
    // The same as one step, in so many seconds; what hands change meanwhile is there at once. Where it is on
    // its way there, it arrives then, if that is sooner.
    void fade_to(Look look, const QString& text, double seconds);
    bool fades() const { return fader_.is_going(); }
    QUndoStack& undo_stack() { return undo_; }
    const QUndoStack& undo_stack() const { return undo_; }
    // The show is another text now, with what goes by index of the fixture as that text counts. It is shown
    // at once as `preview`, until the engine has opened it.
    void put_edit(std::shared_ptr<const std::string> text, scene::Show preview, const Look& look,
                  std::set<std::size_t> selection);

    // The text is the same, and files that the show names are others now: they are read again. What hands
    // hold stays with the heads and objects that it is on.
    void read_again(std::shared_ptr<const std::string> text);

    // Of fixtures and movers that another text, or the next version, of the show does not have.
    void tell_lost(const std::vector<std::string>& names);

    // Long work in the background.
    Jobs& jobs() { return jobs_; }
    const Jobs& jobs() const { return jobs_; }

    // From the receipt of packets to the painting of the picture that shows them first.
    const dmx::Latency& latency() const { return latency_; }
    void count_latency(std::chrono::nanoseconds latency) { latency_.add(latency); }

    // Fixtures, by index of the show.
    const std::set<std::size_t>& selection() const { return selection_; }
    // The same in the order in which they were selected; those that came at once, by the list.
    const std::vector<std::size_t>& selected_in_order() const { return selected_in_order_; }
    void select(std::set<std::size_t> fixtures);
    void select_in_order(std::vector<std::size_t> fixtures); // each once
    // An object of the stage that the picture shall point out; index into Opened::objects.
    void mark(std::optional<std::size_t> object);
    std::optional<std::size_t> marked() const;
    // The one that panels are about: the first selected one.
    std::optional<std::size_t> current() const;

    // Whether the picture shows all that is asked for, at rest.
    bool is_settled() const {
        return show() && !is_opening() && !travels() && !fades() && settled_ == request_.number;
    }

Q_SIGNALS:
    void opened_show();
    void failed(const QString& what);
    void not_opened(); // open_error says why; failed says it, too
    void picture_came();
    void rig_came();
    void network_came();
    void explanation_came();
    void hovered_came();
    void verdicts_came();
    void messages_came();
    void activity_came();
    void bounce_came();
    void unseen_stage_came();
    void rdm_came();
    void rdm_edit_asked(const RdmEdit& asked); // by a desk
    void probe_came();
    void picked_came();
    void waveform_came();
    void recording_ended();
    void picture_saved(const QString& error); // empty: it is there
    void plot_came();
    void camera_pictures_came();
    void look_called(const QString& name, double seconds); // by a remote control; below 0: those of the look
    void cue_called(const QString& name);                  // likewise; what it recalls is called, too
    void request_changed();
    void look_changed();
    void selection_changed();
    void marked_changed();
    void news_came(); // after all of the others

private:
    friend class LookStep;

    void read_news();
    std::optional<Explained> shown_place_of(std::optional<Explained> news) const;
    void count_news_anew(const scene::Show& before, const scene::Show& now);
    void take_opened(Opened opened);
    void go_on_from(const Opened& before, bool are_files_others);
    void show_edit();
    void put_look(const Look& look);
    void show_look();
    void send_size();
    void put_camera(const scene::Camera& camera, const glm::ivec2& frame);
    void put_selection(std::set<std::size_t> fixtures);
    void send();

    Link& link_;
    std::atomic<bool> news_posted_{false};
    Opened opened_;
    std::shared_ptr<const scene::Show> drawn_; // by the engine: that before an edit which is shown already
    Picture picture_;
    RigNow rig_;
    dmx::Statistics network_;
    scene::PatchMap patch_; // of the show
    dmx::Latency latency_;
    dmx::Latency window_cost_;
    std::chrono::nanoseconds news_cost_{0}; // since the last picture was painted
    QSize view_size_, second_size_;
    Explained explained_;
    std::optional<Explained> hovered_;
    std::vector<Verdict> verdicts_;
    std::vector<Message> messages_;
    std::string activity_;
    BounceNow bounce_;
    UnseenStage unseen_stage_;
    RdmNow rdm_;
    ReceivedPlot plot_;
    std::vector<NamedPicture> camera_pictures_;
    std::optional<Probed> probed_;
    Picked picked_;
    std::vector<float> waveform_;
    std::uint64_t saved_ = 0;
    Recorded recorded_;

    ViewRequest request_;
    std::uint64_t made_of_plot_ = 0;   // number of the last such request
    std::uint64_t copy_ = 0;           // likewise, of open_copy
    std::uint64_t answered_opens_ = 0; // the newest that is open, or cannot be
    std::optional<Error> open_error_;
    std::uint64_t settled_ = 0;
    std::set<std::size_t> selection_;
    std::vector<std::size_t> selected_in_order_;
    std::optional<std::size_t> marked_;
    std::uint64_t choices_ = 0;     // grows with what is selected or marked
    bool are_files_others_ = false; // of the text that is asked for (read_again)
    bool is_elsewhere_ = false;     // what is open is not what the request names
    QUndoStack undo_;
    Jobs jobs_;

    CameraFlight flight_;
    Look look_;
    LookFader fader_;
};

} // namespace ghost::ui
