//! A reader of the page: headless Chromium, with a mouse, a finger and a keyboard.

use std::{
    ffi::OsStr,
    fs,
    path::Path,
    sync::{Arc, Mutex},
    thread,
    time::{Duration, Instant},
};

use headless_chrome::{
    Browser, LaunchOptions, Tab,
    protocol::cdp::{
        Emulation,
        Input::{
            DispatchMouseEvent, DispatchMouseEventTypeOption as Mouse, DispatchTouchEvent,
            DispatchTouchEventTypeOption as Finger, MouseButton, TouchPoint,
        },
        Network,
        Page::CaptureScreenshotFormatOption,
        Runtime,
        types::Event,
    },
};
use serde_json::Value;

/// The longest wait for a part of the page.
const PATIENCE: Duration = Duration::from_secs(60);

/// No network, no first run, nothing in the background.
const FLAGS: [&str; 7] = [
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
];

/// Headless Chromium with the page open.
pub(super) struct Reader {
    tab: Arc<Tab>,
    troubles: Arc<Mutex<Vec<String>>>,
    /// It ends with its owner.
    _browser: Browser,
}

impl Reader {
    /// Opens the page in a window of this size, in pixels, and waits for its first curve.
    pub(super) fn open(file: &Path, width: u32, height: u32) -> Self {
        let options = LaunchOptions {
            // In a container, and as root, the sandbox does not start. The page is our own.
            sandbox: false,
            args: FLAGS.iter().map(OsStr::new).collect(),
            idle_browser_timeout: Duration::from_secs(300),
            ..LaunchOptions::default()
        };
        let browser = Browser::new(options).expect("Chromium starts");
        let tab = browser.new_tab().expect("a tab");
        let troubles = listen(&tab);
        let reader = Self { tab, troubles, _browser: browser };
        reader.resize(width, height);
        let address = format!("file://{}", file.display());
        reader.tab.navigate_to(&address).expect("an address");
        reader.wait_for("window.page !== undefined");
        reader
    }

    fn resize(&self, width: u32, height: u32) {
        let metrics = Emulation::SetDeviceMetricsOverride {
            width,
            height,
            device_scale_factor: 1.0,
            mobile: false,
            scale: None,
            screen_width: None,
            screen_height: None,
            position_x: None,
            position_y: None,
            dont_set_visible_size: None,
            screen_orientation: None,
            viewport: None,
            display_feature: None,
            device_posture: None,
        };
        self.tab.call_method(metrics).expect("a size");
    }

    /// Runs a script on the page.
    pub(super) fn run(&self, script: &str) {
        self.tab.evaluate(script, false).unwrap_or_else(|error| panic!("{script}: {error}"));
    }

    /// Returns the value of an expression on the page.
    pub(super) fn json(&self, expression: &str) -> Value {
        let script = format!("JSON.stringify({expression})");
        let result = self.tab.evaluate(&script, false);
        let value = result.unwrap_or_else(|error| panic!("{expression}: {error}")).value;
        let text = value.as_ref().and_then(Value::as_str).unwrap_or("null");
        serde_json::from_str(text).expect("a document")
    }

    fn wait_for(&self, condition: &str) {
        let start = Instant::now();
        while self.json(&format!("Boolean({condition})")) != true {
            assert!(start.elapsed() < PATIENCE, "{condition} is not true: {:?}", self.troubles());
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits for the next frame and the one after, in which the page draws what was asked before.
    fn wait_for_frame(&self) {
        let script =
            "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))";
        self.tab.evaluate(script, true).expect("a frame");
    }

    /// Returns the text of an element.
    pub(super) fn text(&self, selector: &str) -> String {
        let text = self.json(&format!("document.querySelector('{selector}').textContent"));
        text.as_str().unwrap_or_else(|| panic!("there is no {selector}")).to_owned()
    }

    /// Waits until the text of an element is as wanted, and returns it.
    pub(super) fn wait_for_text(&self, selector: &str, wanted: impl Fn(&str) -> bool) -> String {
        let start = Instant::now();
        loop {
            let text = self.text(selector);
            if wanted(&text) {
                return text;
            }
            assert!(start.elapsed() < PATIENCE, "{selector} is still {text:?}");
            thread::sleep(Duration::from_millis(20));
        }
    }

    pub(super) fn attribute(&self, selector: &str, name: &str) -> String {
        let value =
            self.json(&format!("document.querySelector('{selector}').getAttribute('{name}')"));
        value.as_str().unwrap_or_else(|| panic!("{selector} has no {name}")).to_owned()
    }

    /// Returns the middle of an element, in pixels of the window.
    fn middle(&self, selector: &str) -> (f64, f64) {
        self.run(&format!(
            "document.querySelector('{selector}').scrollIntoView({{ block: 'nearest' }})"
        ));
        let script = format!(
            "(({{ left, top, width, height }}) => [left + width / 2, top + height / 2])\
             (document.querySelector('{selector}').getBoundingClientRect())"
        );
        let middle = self.json(&script);
        (middle[0].as_f64().expect("a number"), middle[1].as_f64().expect("a number"))
    }

    /// Drags an element with the mouse, in ten steps.
    pub(super) fn drag(&self, selector: &str, (right, down): (f64, f64)) {
        let (x, y) = self.middle(selector);
        self.mouse(Mouse::MousePressed, (x, y));
        for step in 1..=10 {
            let part = f64::from(step) / 10.0;
            self.mouse(Mouse::MouseMoved, (x + part * right, y + part * down));
        }
        self.mouse(Mouse::MouseReleased, (x + right, y + down));
        self.wait_for_frame();
    }

    fn mouse(&self, what: Mouse, (x, y): (f64, f64)) {
        let pressed = u32::from(what != Mouse::MouseReleased);
        let event = DispatchMouseEvent {
            Type: what,
            x,
            y,
            modifiers: None,
            timestamp: None,
            button: Some(MouseButton::Left),
            buttons: Some(pressed),
            click_count: Some(1),
            force: None,
            tangential_pressure: None,
            tilt_x: None,
            tilt_y: None,
            twist: None,
            delta_x: None,
            delta_y: None,
            pointer_Type: None,
        };
        self.tab.call_method(event).expect("a mouse");
    }

    /// Drags an element with a finger, in ten steps.
    pub(super) fn touch_drag(&self, selector: &str, (right, down): (f64, f64)) {
        let (x, y) = self.middle(selector);
        self.finger(Finger::TouchStart, Some((x, y)));
        for step in 1..=10 {
            let part = f64::from(step) / 10.0;
            self.finger(Finger::TouchMove, Some((x + part * right, y + part * down)));
        }
        self.finger(Finger::TouchEnd, None);
        self.wait_for_frame();
    }

    fn finger(&self, what: Finger, at: Option<(f64, f64)>) {
        let point = |(x, y)| TouchPoint {
            x,
            y,
            radius_x: None,
            radius_y: None,
            rotation_angle: None,
            force: None,
            tangential_pressure: None,
            tilt_x: None,
            tilt_y: None,
            twist: None,
            id: None,
        };
        let touch_points = at.into_iter().map(point).collect();
        let event =
            DispatchTouchEvent { Type: what, touch_points, modifiers: None, timestamp: None };
        self.tab.call_method(event).expect("a finger");
    }

    /// Presses a key.
    pub(super) fn press(&self, key: &str) {
        self.tab.press_key(key).expect("a key");
        self.wait_for_frame();
    }

    /// Replaces the formula, typing letter by letter.
    pub(super) fn type_formula(&self, formula: &str) {
        self.run("document.getElementById('formula').focus(); document.getElementById('formula').select()");
        self.tab.type_str(formula).expect("a keyboard");
        self.wait_for_frame();
    }

    /// Writes a picture of the whole page.
    pub(super) fn picture(&self, file: &Path) {
        // The bands follow a formula after a pause.
        thread::sleep(Duration::from_millis(400));
        let width = self.json("innerWidth").as_u64().expect("a number") as u32;
        let before = self.json("innerHeight").as_u64().expect("a number") as u32;
        let height = self.json("document.documentElement.scrollHeight").as_u64().expect("a number");
        self.resize(width, height as u32);
        let png = CaptureScreenshotFormatOption::Png;
        let bytes = self.tab.capture_screenshot(png, None, None, true).expect("a picture");
        self.resize(width, before);
        fs::write(file, bytes).expect("written");
    }

    /// Returns errors of scripts, and requests that leave the file.
    pub(super) fn troubles(&self) -> Vec<String> {
        self.troubles.lock().expect("no listener panicked").clone()
    }
}

fn listen(tab: &Tab) -> Arc<Mutex<Vec<String>>> {
    let found = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&found);
    let listener = move |event: &Event| {
        let trouble = match event {
            Event::RuntimeExceptionThrown(event) => {
                let details = &event.params.exception_details;
                let thrown = details.exception.as_ref().and_then(|it| it.description.clone());
                Some(thrown.unwrap_or_else(|| details.text.clone()))
            }
            Event::NetworkRequestWillBeSent(event) => {
                let url = &event.params.request.url;
                let stays = ["file:", "data:", "blob:"].iter().any(|kind| url.starts_with(kind));
                (!stays).then(|| format!("a request for {url}"))
            }
            _ => None,
        };
        if let (Some(trouble), Ok(mut found)) = (trouble, seen.lock()) {
            found.push(trouble);
        }
    };
    tab.add_event_listener(Arc::new(listener)).expect("a listener");
    tab.call_method(Runtime::Enable(None)).expect("errors of scripts");
    let network = Network::Enable {
        max_total_buffer_size: None,
        max_resource_buffer_size: None,
        max_post_data_size: None,
        report_direct_socket_traffic: None,
        enable_durable_messages: None,
    };
    tab.call_method(network).expect("requests");
    found
}
