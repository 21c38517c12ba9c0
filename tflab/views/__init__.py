"""Draw figures, panels and 3D scenes, each with its text.

    style, libraries, picture    sizes, colours and numbers; the widget libraries; a figure with its text
    rerun            frees a cell's views when it runs again
    projection       from space onto paper; robots and posts
    frames, labels, number_table    frames, names and numbers on paper
    axes, rotations  conventions of axes, and rotations
    sentence         a lookup, its target and its source
    wrong_frames, transform_chain, coordinates    wrong frames, products, one point in many frames
    motion_error, map_error, moved_frames    what latency, a wrong pose and a jump cost
    timeline, clocks, ages, busy_chart, late_joiner    time: the buffer, clocks, delays, executors, durability
    fault_tables, diagnosis_log    diagnosis
    sheet, tree, tree_path, view_frames_tree    the frame tree as SVG, PDF and text
    rviz_status, rviz, rviz_figure    what RViz shows and reports
    turtles          the field of turtlesim
    scene/           3D in the page
    panels/          sliders in front of the figures
    slider_frames, export_widgets, export    pages without a kernel
    report_page      an HTML report

A view receives values and, where it must look up, a function `ask(target_frame, source_frame,
stamp_ns)`; it never holds a buffer or a graph. It returns what it drew, with its text.
"""
