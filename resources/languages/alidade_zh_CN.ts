<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AccessibleCell</name>
    <message>
        <source>%1: empty</source>
        <extracomment>of a cell of a table: the name of its column</extracomment>
        <translation>%1：空</translation>
    </message>
</context>
<context>
    <name>AddPosition</name>
    <message>
        <source>Measure %1° again</source>
        <translation>复测 %1°</translation>
    </message>
    <message>
        <source>Add position at %1°</source>
        <translation>添加轴位 %1°</translation>
    </message>
</context>
<context>
    <name>Busy</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>CalendarButton</name>
    <message>
        <source>Choose in a calendar</source>
        <translation>在日历中选择</translation>
    </message>
</context>
<context>
    <name>ChangeEffects</name>
    <message>
        <source>Estimate %1</source>
        <translation>估计%1</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <translation>去掉%1</translation>
    </message>
</context>
<context>
    <name>ChangeField</name>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
</context>
<context>
    <name>ChangeInstrument</name>
    <message>
        <source>Take from the instrument record</source>
        <translation>取自仪器档案</translation>
    </message>
</context>
<context>
    <name>ChangeKnown</name>
    <message>
        <source>Change known size of %1</source>
        <translation>更改%1的已知值</translation>
    </message>
</context>
<context>
    <name>ChangeOwnEffects</name>
    <message>
        <source>Keep the effect %1</source>
        <translation>保留效应 %1</translation>
    </message>
</context>
<context>
    <name>ChangeProtocol</name>
    <message>
        <source>Follow a protocol</source>
        <translation>按方案测量</translation>
    </message>
    <message>
        <source>Follow no protocol</source>
        <translation>不按方案测量</translation>
    </message>
</context>
<context>
    <name>ChangedFileText</name>
    <message>
        <source>“%1” was written by another program or window since it was last read or saved here.</source>
        <translation>“%1”自上次在此读取或保存以来，已被其他程序或窗口写入。</translation>
    </message>
    <message>
        <source>The file is no longer a session: %1</source>
        <translation>该文件已不再是测量记录：%1</translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>文件已更改</translation>
    </message>
    <message>
        <source>In this window</source>
        <translation>本窗口中</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>文件中</translation>
    </message>
    <message>
        <source>Reload uses the file&apos;s content; undo restores the content of this window. Overwrite replaces the file&apos;s content and cannot be undone.</source>
        <translation>重新载入采用文件的内容；撤销可恢复本窗口的内容。覆盖将替换文件的内容，且无法撤销。</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>重新载入(&amp;R)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>覆盖(&amp;O)</translation>
    </message>
</context>
<context>
    <name>ChoiceText</name>
    <message>
        <source>slider</source>
        <translation>滑块</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>竖直</translation>
    </message>
</context>
<context>
    <name>ConnectionText</name>
    <message>
        <source>No instrument connected</source>
        <translation>未连接仪器</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1，序列号 %2</translation>
    </message>
    <message>
        <source>%1: reading…</source>
        <translation>%1：正在读取…</translation>
    </message>
    <message>
        <source>%1: open</source>
        <translation>%1：已打开</translation>
    </message>
    <message>
        <source>%1: connected</source>
        <translation>%1：已连接</translation>
    </message>
</context>
<context>
    <name>DialogsText</name>
    <message>
        <source>Sessions (*.alidade);;All files (*)</source>
        <translation>测量记录 (*.alidade);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Discarded changes cannot be brought back.</source>
        <translation>丢弃的更改无法恢复。</translation>
    </message>
    <message>
        <source>An import that was undone has not been saved.</source>
        <translation>被撤销的导入尚未保存。</translation>
    </message>
    <message>
        <source>The session before the import has not been saved.</source>
        <translation>导入之前的测量记录尚未保存。</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes, too.</source>
        <translation>“%1”也有未保存的更改。</translation>
    </message>
    <message>
        <source>Redo restores this session with everything typed, so that you can save it.</source>
        <translation>重做可恢复该测量记录及录入的全部内容，以便保存。</translation>
    </message>
    <message>
        <source>Undo restores this session with everything typed, so that you can save it.</source>
        <translation>撤销可恢复该测量记录及录入的全部内容，以便保存。</translation>
    </message>
    <message>
        <source>If discarded, it cannot be brought back.</source>
        <translation>丢弃后无法恢复。</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>打开测量记录</translation>
    </message>
    <message>
        <source>Sessions and reports (*.alidade *.pdf);;Sessions (*.alidade);;Reports with a session in them (*.pdf);;All files (*)</source>
        <translation>测量记录和报告 (*.alidade *.pdf);;测量记录 (*.alidade);;内含测量记录的报告 (*.pdf);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Import readings</source>
        <translation>导入读数</translation>
    </message>
    <message>
        <source>Readings (%1);;All files (*)</source>
        <translation>读数 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save session as</source>
        <translation>测量记录另存为</translation>
    </message>
    <message>
        <source>Export acceptance report</source>
        <translation>导出验收报告</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>封存</translation>
    </message>
    <message>
        <source>The journal records who seals this session, and a digest of its content.
The session can be edited afterwards as a revision; the journal records every edit.

Sealed by:</source>
        <translation>更改日志将记录由谁封存本测量记录，以及其全部内容的摘要。
此后仍可作为修订编辑，每次编辑都会被记载。

封存人：</translation>
    </message>
    <message>
        <source>Already open</source>
        <translation>已在别处打开</translation>
    </message>
    <message>
        <source>“%1” is open in another window (%2).</source>
        <translation>“%1”已在另一窗口（%2）打开。</translation>
    </message>
    <message>
        <source>Changes saved in one window do not appear in the other. Each window asks before it overwrites the other&apos;s changes.</source>
        <translation>在一个窗口中保存的更改不会出现在另一个窗口。任一窗口在覆盖对方的更改之前都会询问。</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>About Alidade</source>
        <translation>关于 Alidade</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Alidade %1&lt;/h3&gt;&lt;p&gt;A measurement workstation for rotatable arc guideways: it computes the intersection and the verdict from sightings.&lt;/p&gt;&lt;p&gt;Licence: GNU General Public License, version 3 or later. Alidade comes without any warranty.&lt;/p&gt;&lt;p&gt;Built with Qt %2.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Alidade %1&lt;/h3&gt;&lt;p&gt;可转动弧形导轨的测量工作站：由照准读数计算相交度并作出判定。&lt;/p&gt;&lt;p&gt;许可证：GNU 通用公共许可证第 3 版或更新版本。Alidade 不提供任何担保。&lt;/p&gt;&lt;p&gt;使用 Qt %2 构建。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>直接输入</translation>
    </message>
    <message>
        <source>overwrites the cell</source>
        <translation>覆盖单元格</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>accepts the entry; goes to vertical, then to the next row</source>
        <translation>提交；转到竖直读数，然后到下一行</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Shift+Tab</translation>
    </message>
    <message>
        <source>accepts the entry; goes to the next or previous shown column</source>
        <translation>提交；转到下一个或上一个显示的列</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>edits what was typed</source>
        <translation>编辑已录入的内容</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>discards the unfinished entry</source>
        <translation>放弃未完成的录入</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>excludes or includes the selected rows</source>
        <translation>排除或恢复使用所选的行</translation>
    </message>
    <message>
        <source>F7</source>
        <translation>F7</translation>
    </message>
    <message>
        <source>goes to the next reading that looks misread</source>
        <translation>转到下一个像是误读的读数</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>enters the reading that was probably meant</source>
        <translation>采用可能正确的读数</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>clears the selected cells</source>
        <translation>清除所选单元格</translation>
    </message>
    <message>
        <source>Ctrl+I, Ctrl+−</source>
        <translation>Ctrl+I, Ctrl+−</translation>
    </message>
    <message>
        <source>inserts a row above; deletes the selected rows</source>
        <translation>在上方插入行；删除所选的行</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+X, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+X, Ctrl+V</translation>
    </message>
    <message>
        <source>copies, cuts, pastes blocks of cells, also from and to spreadsheets</source>
        <translation>复制、剪切、粘贴单元格区域，也可与电子表格交换</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>imports the clipboard after asking for its layout</source>
        <translation>导入剪贴板，并先询问其格式</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Shift+Z</source>
        <translation>Ctrl+Z, Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>撤销、重做</translation>
    </message>
    <message>
        <source>3415224</source>
        <translation>3415224</translation>
    </message>
    <message>
        <source>means 341°52′24″; digits only, as on a number pad</source>
        <translation>即 341°52′24″；只输数字，便于使用数字键盘</translation>
    </message>
    <message>
        <source>Keys of the table</source>
        <translation>表格按键</translation>
    </message>
    <message>
        <source>Font of the window</source>
        <translation>窗口字体</translation>
    </message>
    <message>
        <source>Take from the instrument record</source>
        <translation>取自仪器档案</translation>
    </message>
    <message>
        <source>Instrument records (*.alidade-instrument);;All files (*)</source>
        <translation>仪器档案 (*.alidade-instrument);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Add sessions</source>
        <translation>添加测量记录</translation>
    </message>
    <message>
        <source>Follow a protocol</source>
        <translation>按方案测量</translation>
    </message>
    <message>
        <source>Measurement protocols (*.alidade-protocol);;All files (*)</source>
        <translation>测量方案 (*.alidade-protocol);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>删除轴位</translation>
    </message>
    <message>
        <source>Delete the position %1?</source>
        <extracomment>%1: &quot;0°&quot;, &quot;180° again&quot;</extracomment>
        <translation>删除轴位 %1？</translation>
    </message>
    <message>
        <source>Its one typed sighting is deleted with it.</source>
        <translation>其中已录入的 1 次照准将一并删除。</translation>
    </message>
    <message>
        <source>Its %1 typed sightings are deleted with it.</source>
        <translation>其中已录入的 %1 次照准将一并删除。</translation>
    </message>
    <message>
        <source>Edit › Undo brings them back.</source>
        <translation>“编辑 › 撤销”可将其恢复。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>丢弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>Sessions and series (*.alidade *.alidade-series);;All files (*)</source>
        <translation>测量记录和系列 (*.alidade *.alidade-series);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Readings of the instrument that are not in “%1” yet: %2.</source>
        <translation>尚未录入“%1”的仪器读数：%2。</translation>
    </message>
    <message>
        <source>Cancel to take them in first: a doubtful reading has a question above the table of readings.</source>
        <translation>请取消，先录入这些读数：有疑问的读数会在读数表上方提问。</translation>
    </message>
    <message>
        <source>Discarded readings cannot be brought back.</source>
        <translation>丢弃的读数无法恢复。</translation>
    </message>
</context>
<context>
    <name>DifferenceText</name>
    <message>
        <source>Entry</source>
        <translation>输入项</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 项</translation>
    </message>
</context>
<context>
    <name>ExplainChange</name>
    <message>
        <source>State the reason</source>
        <translation>说明原因</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>place</source>
        <translation>地点</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>report number</source>
        <translation>报告编号</translation>
    </message>
    <message>
        <source>laboratory</source>
        <translation>实验室</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>客户</translation>
    </message>
    <message>
        <source>authorised by</source>
        <translation>批准人</translation>
    </message>
    <message>
        <source>decision rule agreed by</source>
        <translation>判定规则的约定方</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>device serial number</source>
        <translation>设备序列号</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>instrument serial number</source>
        <translation>仪器序列号</translation>
    </message>
    <message>
        <source>instrument certificate</source>
        <translation>仪器证书</translation>
    </message>
    <message>
        <source>traceability of the circles</source>
        <translation>度盘的溯源性</translation>
    </message>
    <message>
        <source>unit of angles</source>
        <translation>角度单位</translation>
    </message>
    <message>
        <source>σ of the horizontal circle</source>
        <translation>水平度盘的 σ</translation>
    </message>
    <message>
        <source>σ of the vertical circle</source>
        <translation>竖直度盘的 σ</translation>
    </message>
    <message>
        <source>σ of the pointing zero</source>
        <translation>瞄准零位的 σ</translation>
    </message>
    <message>
        <source>σ of the slider</source>
        <translation>滑块的 σ</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>σ of the temperature</source>
        <translation>温度的 σ</translation>
    </message>
    <message>
        <source>distance L</source>
        <translation>距离 L</translation>
    </message>
    <message>
        <source>σ of the distance</source>
        <translation>距离的 σ</translation>
    </message>
    <message>
        <source>nominal radius</source>
        <translation>标称半径</translation>
    </message>
    <message>
        <source>σ of the radius</source>
        <translation>半径的 σ</translation>
    </message>
    <message>
        <source>vertical circle</source>
        <translation>竖直度盘</translation>
    </message>
    <message>
        <source>pointing zeros</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>method of the distance measurement</source>
        <translation>距离的测量方法</translation>
    </message>
    <message>
        <source>expansion of the distance</source>
        <translation>距离的膨胀</translation>
    </message>
    <message>
        <source>expansion of the radius</source>
        <translation>半径的膨胀</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>允差</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>包含概率</translation>
    </message>
    <message>
        <source>reference intersection</source>
        <translation>参考相交度</translation>
    </message>
    <message>
        <source>σ of the reference</source>
        <translation>参考值的 σ</translation>
    </message>
    <message>
        <source>quantity limited by the tolerance</source>
        <translation>允差所限制的量</translation>
    </message>
    <message>
        <source>vertical angle relation</source>
        <translation>竖直角关系式</translation>
    </message>
    <message>
        <source>radius model</source>
        <translation>半径模型</translation>
    </message>
    <message>
        <source>axis position</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>pointing zero α0</source>
        <translation>瞄准零位 α0</translation>
    </message>
    <message>
        <source>pointing zero β0</source>
        <translation>瞄准零位 β0</translation>
    </message>
    <message>
        <source>pointing zero α0 in face 2</source>
        <translation>盘右瞄准零位 α0</translation>
    </message>
    <message>
        <source>pointing zero β0 in face 2</source>
        <translation>盘右瞄准零位 β0</translation>
    </message>
    <message>
        <source>pointing zero α0 after the readings</source>
        <translation>读数后瞄准零位 α0</translation>
    </message>
    <message>
        <source>pointing zero β0 after the readings</source>
        <translation>读数后瞄准零位 β0</translation>
    </message>
    <message>
        <source>pointing zero α0 after the readings in face 2</source>
        <translation>盘右读数后瞄准零位 α0</translation>
    </message>
    <message>
        <source>pointing zero β0 after the readings in face 2</source>
        <translation>盘右读数后瞄准零位 β0</translation>
    </message>
    <message>
        <source>σ of the compensator</source>
        <translation>补偿器的 σ</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>测量方案</translation>
    </message>
    <message>
        <source>offset of the line of sight</source>
        <translation>视线偏距</translation>
    </message>
    <message>
        <source>u of the offset of the line of sight</source>
        <translation>视线偏距的 u</translation>
    </message>
    <message>
        <source>correlation of the offset with the collimation</source>
        <translation>视线偏距与照准差的相关系数</translation>
    </message>
    <message>
        <source>time of the pointing zero</source>
        <translation>瞄准零位的时间</translation>
    </message>
    <message>
        <source>return code of the pointing zero</source>
        <translation>瞄准零位的返回码</translation>
    </message>
    <message>
        <source>instrument serial number of the pointing zero</source>
        <translation>瞄准零位的仪器序列号</translation>
    </message>
    <message>
        <source>time of the pointing zero in face 2</source>
        <translation>盘右瞄准零位的时间</translation>
    </message>
    <message>
        <source>return code of the pointing zero in face 2</source>
        <translation>盘右瞄准零位的返回码</translation>
    </message>
    <message>
        <source>instrument serial number of the pointing zero in face 2</source>
        <translation>盘右瞄准零位的仪器序列号</translation>
    </message>
    <message>
        <source>time of the pointing zero after the readings</source>
        <translation>读数后瞄准零位的时间</translation>
    </message>
    <message>
        <source>return code of the pointing zero after the readings</source>
        <translation>读数后瞄准零位的返回码</translation>
    </message>
    <message>
        <source>instrument serial number of the pointing zero after the readings</source>
        <translation>读数后瞄准零位的仪器序列号</translation>
    </message>
    <message>
        <source>time of the pointing zero after the readings in face 2</source>
        <translation>盘右读数后瞄准零位的时间</translation>
    </message>
    <message>
        <source>return code of the pointing zero after the readings in face 2</source>
        <translation>盘右读数后瞄准零位的返回码</translation>
    </message>
    <message>
        <source>instrument serial number of the pointing zero after the readings in face 2</source>
        <translation>盘右读数后瞄准零位的仪器序列号</translation>
    </message>
    <message>
        <source>plane of the arc</source>
        <translation>圆弧平面</translation>
    </message>
    <message>
        <source>target of the pointing zeros</source>
        <translation>瞄准零位所照准的对象</translation>
    </message>
    <message>
        <source>condition of the device</source>
        <translation>设备状况</translation>
    </message>
    <message>
        <source>day of receipt</source>
        <translation>接收日期</translation>
    </message>
</context>
<context>
    <name>FileLock</name>
    <message>
        <source>process %1</source>
        <translation>进程 %1</translation>
    </message>
</context>
<context>
    <name>Forms</name>
    <message>
        <source>0 (exact)</source>
        <translation>0（精确）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Zenith</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>高度角</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>Planar</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Common</source>
        <translation>公共</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>已知</translation>
    </message>
    <message>
        <source>Δd</source>
        <translation>Δd</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance &amp;L</source>
        <translation>距离 L(&amp;L)</translation>
    </message>
    <message>
        <source>required</source>
        <translation>必填</translation>
    </message>
    <message>
        <source>From the theodolite&apos;s centre to the plane of the arc</source>
        <translation>从经纬仪中心到圆弧平面</translation>
    </message>
    <message>
        <source>σ of L</source>
        <translation>L 的 σ</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance; empty means exact</source>
        <translation>距离的标准不确定度；空表示精确</translation>
    </message>
    <message>
        <source>&amp;Radius R0</source>
        <translation>半径 R0(&amp;R)</translation>
    </message>
    <message>
        <source>Nominal radius of the arc</source>
        <translation>圆弧的标称半径</translation>
    </message>
    <message>
        <source>σ of R0</source>
        <translation>R0 的 σ</translation>
    </message>
    <message>
        <source>Standard uncertainty of the nominal radius. With a known radius, it weights R0 in the fit; empty means exact. With a free or common radius, it makes R − R0 a closure; empty means no closure</source>
        <translation>标称半径的标准不确定度。半径为“已知”时，它决定 R0 在拟合中的权，空表示精确；其他情况下，填写后 R − R0 作为闭合差，空则不作闭合差</translation>
    </message>
    <message>
        <source>R&amp;adius is</source>
        <translation>半径为(&amp;A)</translation>
    </message>
    <message>
        <source>Free: a radius for each arc. Common: one radius for both arcs. Known: R0 with its σ is one more observation</source>
        <translation>自由：每个圆弧各有半径。公共：两个圆弧共用一个。已知：R0 及其 σ 作为一个附加观测值参与</translation>
    </message>
    <message>
        <source>Vert. c&amp;ircle</source>
        <translation>竖直度盘(&amp;I)</translation>
    </message>
    <message>
        <source>What the vertical circle reads: zenith angles grow downwards, elevation angles upwards</source>
        <translation>竖直度盘的读数：天顶距向下增大，高度角向上增大</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>关系式</translation>
    </message>
    <message>
        <source>Exact: tan e = y/√(x²+L²), what a theodolite reads. Planar: tan e = y/L, as in the published method</source>
        <translation>精确：tan e = y/√(x²+L²)，即经纬仪所读。平面：tan e = y/L，即已发表的方法</translation>
    </message>
    <message>
        <source>Covera&amp;ge</source>
        <translation>包含概率(&amp;G)</translation>
    </message>
    <message>
        <source>0.95</source>
        <translation>0.95</translation>
    </message>
    <message>
        <source>Coverage probability of the expanded uncertainty U, between 0 and 1</source>
        <translation>扩展不确定度 U 的包含概率，在 0 和 1 之间</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>允差(&amp;T)</translation>
    </message>
    <message>
        <source>Largest acceptable value of the quantity under “Limits”; without a tolerance there is no verdict</source>
        <translation>“限制”所选量的最大可接受值；没有允差则不作判定</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>σ of ref.</source>
        <translation>参考值 σ</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reference. If stated, Δd − reference is a closure and may help the diagnosis to distinguish causes; Δd never depends on the reference</source>
        <translation>参考值的标准不确定度。填写后，Δd 与参考值之差构成一个闭合差，可帮助诊断区分各原因；Δd 从不依赖于参考值</translation>
    </message>
    <message>
        <source>″</source>
        <translation>″</translation>
    </message>
    <message>
        <source>Unstated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>Each</source>
        <translation>各自照准</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>共用一个</translation>
    </message>
    <message>
        <source>model</source>
        <translation>型号</translation>
    </message>
    <message>
        <source>Serial no.</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Pointing zeros</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>Each: sighted again in every position. One for all: sighted once, so that its error cancels in Δd</source>
        <translation>各自照准：在每个轴位重新照准。共用一个：为所有轴位只照准一次，其误差在 Δd 中抵消</translation>
    </message>
    <message>
        <source>σ ho&amp;rizontal</source>
        <translation>水平 σ(&amp;R)</translation>
    </message>
    <message>
        <source>2</source>
        <translation>2</translation>
    </message>
    <message>
        <source>Stated standard deviation of one horizontal reading</source>
        <translation>给定的单次水平读数标准偏差</translation>
    </message>
    <message>
        <source>σ vertical</source>
        <translation>竖直 σ</translation>
    </message>
    <message>
        <source>Stated standard deviation of one vertical reading</source>
        <translation>给定的单次竖直读数标准偏差</translation>
    </message>
    <message>
        <source>σ of &amp;zeros</source>
        <translation>零位 σ(&amp;Z)</translation>
    </message>
    <message>
        <source>same as circles</source>
        <translation>同度盘</translation>
    </message>
    <message>
        <source>Standard uncertainty of one sighting of the pointing zeros α0 and β0</source>
        <translation>单次照准瞄准零位 α0、β0 的标准不确定度</translation>
    </message>
    <message>
        <source>σ slider</source>
        <translation>滑块 σ</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>Standard deviation of one slider reading</source>
        <translation>单次滑块读数的标准偏差</translation>
    </message>
    <message>
        <source>Dev&amp;ice</source>
        <translation>设备(&amp;I)</translation>
    </message>
    <message>
        <source>simulator under test</source>
        <translation>被测的模拟器</translation>
    </message>
    <message>
        <source>R0 expands</source>
        <translation>R0 的膨胀</translation>
    </message>
    <message>
        <source>ppm/K</source>
        <translation>ppm/K</translation>
    </message>
    <message>
        <source>Expansion of R0 per kelvin; R0 is stated for 20 °C. Steel: 11.5</source>
        <translation>温度每升高 1 K，R0 的膨胀量；R0 以 20 °C 为准。钢：11.5</translation>
    </message>
    <message>
        <source>Re&amp;port no.</source>
        <translation>报告编号(&amp;P)</translation>
    </message>
    <message>
        <source>Unique number of the report, printed on each of its pages</source>
        <translation>报告的唯一编号，印在每一页上</translation>
    </message>
    <message>
        <source>Person responsible for the report</source>
        <translation>对报告负责的人</translation>
    </message>
    <message>
        <source>&amp;Laboratory</source>
        <translation>实验室(&amp;L)</translation>
    </message>
    <message>
        <source>name and address</source>
        <translation>名称和地址</translation>
    </message>
    <message>
        <source>Rule a&amp;greed by</source>
        <translation>规则约定方(&amp;G)</translation>
    </message>
    <message>
        <source>who, and in which document</source>
        <translation>何人，载于何处</translation>
    </message>
    <message>
        <source>With whom the decision rule was agreed: accept only where |Δd| + U is within the tolerance, reject only where |Δd| − U is beyond it</source>
        <translation>与谁约定判定规则：仅当 |Δd| + U 在允差之内时判为合格，仅当 |Δd| − U 超出允差时判为不合格</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Calibration certificate of the instrument, for the report</source>
        <translation>仪器的校准证书，供报告使用</translation>
    </message>
    <message>
        <source>L measured</source>
        <translation>L 的测量</translation>
    </message>
    <message>
        <source>how</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>How the distance was measured, and its traceability; for the report</source>
        <translation>距离的测量方法及其溯源性；供报告使用</translation>
    </message>
    <message>
        <source>Circles traceable</source>
        <translation>度盘溯源</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>To which standards the circles are traceable, and through whom; for the report</source>
        <translation>度盘溯源到何种标准、经由何处；供报告使用</translation>
    </message>
    <message>
        <source>T&amp;itle</source>
        <translation>标题(&amp;I)</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>地点(&amp;P)</translation>
    </message>
    <message>
        <source>D&amp;ate</source>
        <translation>日期(&amp;A)</translation>
    </message>
    <message>
        <source>YYYY-MM-DD</source>
        <translation>年-月-日</translation>
    </message>
    <message>
        <source>Day of the measurement</source>
        <translation>测量日期</translation>
    </message>
    <message>
        <source>&amp;Temp.</source>
        <translation>温度(&amp;T)</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>Temperature of the device and of the air</source>
        <translation>设备和空气的温度</translation>
    </message>
    <message>
        <source>σ of temp.</source>
        <translation>温度 σ</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Standard uncertainty of the temperature</source>
        <translation>温度的标准不确定度</translation>
    </message>
    <message>
        <source>L expands</source>
        <translation>L 的膨胀</translation>
    </message>
    <message>
        <source>Expansion of L per kelvin if L is stated for 20 °C; empty if L was measured at the temperature of this session</source>
        <translation>L 以 20 °C 为准时，温度每升高 1 K，L 的膨胀量；若 L 就是在本次测量温度下测得，则留空</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>σ compensator</source>
        <translation>补偿器 σ</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Setting accuracy of the compensator from its data sheet; used if the rows have tilts or state what the instrument corrected</source>
        <translation>补偿器的安置精度，见其说明书；当读数带有倾斜量，或注明了仪器所作的改正时使用</translation>
    </message>
    <message>
        <source>Line of sight e</source>
        <translation>视线偏距 e</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Offset e of the line of sight from the vertical axis, from the instrument check; e/D, with the distance D of the slider, is added to the known collimation</source>
        <translation>视线偏离竖轴的距离 e，由仪器检查得出：将 e/D 计入已知的照准差，D 为到滑块的距离</translation>
    </message>
    <message>
        <source>u of e</source>
        <translation>e 的 u</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>Standard uncertainty of the offset of the line of sight</source>
        <translation>视线偏距的标准不确定度</translation>
    </message>
    <message>
        <source>Correlation of e</source>
        <translation>e 的相关系数</translation>
    </message>
    <message>
        <source>Correlation of the offset with the known collimation, −1 to 1: both come from one fit</source>
        <translation>视线偏距与已知照准差的相关系数，−1 至 1：两者由同一拟合得出</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>铅垂</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>垂直于零位</translation>
    </message>
    <message>
        <source>Arc&apos;s plane</source>
        <translation>圆弧平面</translation>
    </message>
    <message>
        <source>For an instrument above or below the axis, whose pointing zero is inclined. Vertical: the plane of the arc is plumb. Square: the plane is perpendicular to the pointing zero</source>
        <translation>仪器高于或低于回转轴时，其瞄准零位是倾斜的。铅垂：圆弧平面仍然铅垂。垂直于零位：圆弧平面与零位方向垂直</translation>
    </message>
    <message>
        <source>A mark</source>
        <translation>标志</translation>
    </message>
    <message>
        <source>The normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Zeros sight</source>
        <translation>零位照准</translation>
    </message>
    <message>
        <source>Mark: a fixed target; different zeros show a drift or a knocked tripod. Normal: the normal of the guideway, set again in each position. Unstated: treated as a mark if the zeros agree within 30″</source>
        <translation>标志：一个固定目标，零位之差反映漂移或三脚架被碰动。法线：导轨自身的法线，在每个轴位重新设定。未说明：零位相差在 30″ 以内时视为标志</translation>
    </message>
    <message>
        <source>Authorised b&amp;y</source>
        <translation>批准人(&amp;Y)</translation>
    </message>
    <message>
        <source>Condition of the device on receipt, for the report</source>
        <translation>接收时设备的状况，用于报告</translation>
    </message>
    <message>
        <source>&amp;Received on</source>
        <translation>接收日期(&amp;R)</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>客户</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>状况</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>The quantity that the tolerance limits. Δd: distance of the arc&apos;s centre from the axis in the plane of the arc. Distance: the whole distance of the centre from the axis</source>
        <translation>允差所限制的量。Δd：圆心到回转轴的距离在圆弧平面内的部分。距离：圆心到回转轴的整个距离</translation>
    </message>
    <message>
        <source>Setting of the device, if known; shown with the result, not used in the fit</source>
        <translation>设备的设定值（如已知）；显示在结果旁，从不参与拟合</translation>
    </message>
</context>
<context>
    <name>HelpPage</name>
    <message>
        <source>First measurement in ten steps</source>
        <translation>十步完成第一次测量</translation>
    </message>
    <message>
        <source>Entering readings</source>
        <translation>录入读数</translation>
    </message>
    <message>
        <source>The result and its verdict</source>
        <translation>结果及其判定</translation>
    </message>
    <message>
        <source>How to read the gap</source>
        <translation>如何理解差距</translation>
    </message>
    <message>
        <source>Uncertainty and reliability</source>
        <translation>不确定度与可靠性</translation>
    </message>
    <message>
        <source>Known sizes and effects</source>
        <translation>已知值与效应</translation>
    </message>
    <message>
        <source>Report, journal and seal</source>
        <translation>报告、日志与封存</translation>
    </message>
    <message>
        <source>Files and recovery</source>
        <translation>文件与恢复</translation>
    </message>
    <message>
        <source>Words and symbols</source>
        <translation>术语与符号</translation>
    </message>
    <message>
        <source>Checking the instrument</source>
        <translation>检查仪器</translation>
    </message>
    <message>
        <source>A device over time</source>
        <translation>设备随时间的变化</translation>
    </message>
    <message>
        <source>Readings from the instrument</source>
        <translation>从仪器读取读数</translation>
    </message>
    <message>
        <source>Checking this installation</source>
        <translation>检查本安装</translation>
    </message>
    <message>
        <source>Forms: uncatalogued effects</source>
        <translation>形式：目录之外的效应</translation>
    </message>
</context>
<context>
    <name>InsetText</name>
    <message>
        <source>tolerance</source>
        <translation>允差</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Provisional</source>
        <translation>暂定</translation>
    </message>
    <message>
        <source>Fitted centres, enlarged</source>
        <translation>拟合的圆心，放大</translation>
    </message>
</context>
<context>
    <name>Known</name>
    <message>
        <source>an effect without a name</source>
        <translation>没有名称的效应</translation>
    </message>
    <message>
        <source>known size of %1</source>
        <translation>%1的已知值</translation>
    </message>
</context>
<context>
    <name>MoveRows</name>
    <message>
        <source>Move %1 readings to %2</source>
        <translation>将 %1 个读数移到 %2</translation>
    </message>
</context>
<context>
    <name>NextReadingText</name>
    <message>
        <source>point %1</source>
        <translation>测点 %1</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>下一读数：%1</translation>
    </message>
    <message>
        <source>%1, about %2 and %3</source>
        <translation>%1，约 %2 和 %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>All readings are taken</source>
        <translation>所有读数均已读取</translation>
    </message>
    <message>
        <source>round %1</source>
        <translation>测回 %1</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>盘位 %1</translation>
    </message>
</context>
<context>
    <name>Phrase</name>
    <message>
        <source>there are no readings to fit; enter the readings of the axis positions</source>
        <translation>没有可拟合的读数；请录入各轴位的读数</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>two sentences, such as what was found and what to do about it</extracomment>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>is empty: type an angle such as 341°52&apos;24&quot;</source>
        <translation>为空：请输入角度，例如 341°52&apos;24&quot;</translation>
    </message>
    <message>
        <source>%1 has no degrees: type them too, such as 0°52&apos;24&quot;</source>
        <translation>%1 没有度：请一并输入度，例如 0°52&apos;24&quot;</translation>
    </message>
    <message>
        <source>%1 is not an angle: type an angle such as 341°52&apos;24&quot;</source>
        <translation>%1 不是角度：请输入角度，例如 341°52&apos;24&quot;</translation>
    </message>
    <message>
        <source>%1 is too large for an angle: check the digits</source>
        <translation>%1 作为角度过大：请检查数字</translation>
    </message>
    <message>
        <source>%1 is ambiguous: type %2 %3 00 or %2°%3&apos;</source>
        <translation>%1 有歧义：请输入 %2 %3 00 或 %2°%3&apos;</translation>
    </message>
    <message>
        <source>%1 has too many digits: type degrees, minutes and seconds as DDDMMSS or with blanks between them</source>
        <translation>%1 的位数过多：请按 DDDMMSS 或用空格分隔输入度、分、秒</translation>
    </message>
    <message>
        <source>%1 may mean decimal degrees or degrees, minutes and seconds: put a degree sign behind decimal degrees, or blanks between degrees, minutes and seconds</source>
        <translation>%1 可能是十进制度，也可能是度分秒：十进制度请加度符号，度分秒请用空格分隔</translation>
    </message>
    <message>
        <source>%1 may mean decimal degrees or degrees, minutes and seconds: type %2 or %3</source>
        <translation>%1 可能是十进制度，也可能是度分秒：请输入 %2 或 %3</translation>
    </message>
    <message>
        <source>%1 may mean decimal degrees or degrees, minutes and seconds: type %2 or put blanks between degrees, minutes and seconds</source>
        <translation>%1 可能是十进制度，也可能是度分秒：请输入 %2，或在度、分、秒之间加空格</translation>
    </message>
    <message>
        <source>%1 mixes separators: use one kind, such as 341 52 24</source>
        <translation>%1 混用了分隔符：请只用一种，例如 341 52 24</translation>
    </message>
    <message>
        <source>%1 has more than three parts: type degrees, minutes and seconds</source>
        <translation>%1 超过三部分：请输入度、分、秒</translation>
    </message>
    <message>
        <source>%1 has decimals before its last part: only the last part may have decimals</source>
        <translation>%1 在最后一部分之前就有小数：只有最后一部分可以有小数</translation>
    </message>
    <message>
        <source>%1 has %2 minutes: minutes go from 0 to 59</source>
        <translation>%1 有 %2 分：分的范围为 0 到 59</translation>
    </message>
    <message>
        <source>%1 has %2 seconds: seconds stay below 60</source>
        <translation>%1 有 %2 秒：秒必须小于 60</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <extracomment>a file and why: &quot;the disk is full: make room there or choose another folder&quot;</extracomment>
        <translation>%1 无法写入：%2</translation>
    </message>
    <message>
        <source>this is the file being read: choose another name</source>
        <translation>这正是所读取的文件：请换一个名称</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>a fault in the program (%1)</source>
        <translation>程序故障（%1）</translation>
    </message>
    <message>
        <source>a fault in the program (cause not reported)</source>
        <translation>程序故障（原因未报告）</translation>
    </message>
    <message>
        <source>is a folder: choose a file in it</source>
        <translation>是文件夹：请选择其中的文件</translation>
    </message>
    <message>
        <source>cannot be opened (%1): check its name and your rights</source>
        <extracomment>what the system says is wrong, in parentheses</extracomment>
        <translation>无法打开（%1）：请检查名称和您的权限</translation>
    </message>
    <message>
        <source>cannot be read to its end: check the medium it is on</source>
        <translation>无法完整读取：请检查其所在的存储介质</translation>
    </message>
    <message>
        <source>the name is used by something other than a file: choose another name</source>
        <translation>该名称已被占用，且不是文件：请换一个名称</translation>
    </message>
    <message>
        <source>the file is read-only: choose another name, or make it writable</source>
        <translation>文件为只读：请换一个名称，或使其可写</translation>
    </message>
    <message>
        <source>no name is given: enter one</source>
        <translation>没有名称：请指定名称</translation>
    </message>
    <message>
        <source>the disk is full: make room there or choose another folder</source>
        <translation>磁盘已满：请腾出空间或选择其他文件夹</translation>
    </message>
    <message>
        <source>your share of the disk is used up: make room there or choose another folder</source>
        <translation>您的磁盘配额已用完：请腾出空间或选择其他文件夹</translation>
    </message>
    <message>
        <source>the file exceeds the size limit of the disk: choose another folder</source>
        <translation>文件超过该磁盘允许的大小：请选择其他文件夹</translation>
    </message>
    <message>
        <source>you may not write there: choose another folder</source>
        <translation>您无权写入该处：请选择其他文件夹</translation>
    </message>
    <message>
        <source>the disk can only be read: choose another folder</source>
        <translation>该磁盘只能读取：请选择其他文件夹</translation>
    </message>
    <message>
        <source>its folder does not exist: choose another folder</source>
        <translation>其文件夹不存在：请选择其他文件夹</translation>
    </message>
    <message>
        <source>a folder has this name: choose another name</source>
        <translation>该处已有同名文件夹：请换一个名称</translation>
    </message>
    <message>
        <source>its name is too long: choose a shorter one</source>
        <translation>名称过长：请选择较短的名称</translation>
    </message>
    <message>
        <source>its links form a loop: choose another name</source>
        <translation>其链接形成循环：请换一个名称</translation>
    </message>
    <message>
        <source>%1: choose another name or folder</source>
        <extracomment>what the system says is wrong</extracomment>
        <translation>%1：请换一个名称或文件夹</translation>
    </message>
    <message>
        <source>is larger than %1: choose another file</source>
        <translation>大于 %1：请选择其他文件</translation>
    </message>
    <message>
        <source>holds more than %1 rows of readings: divide them into several sessions</source>
        <translation>含有超过 %1 行读数：请分成多份测量记录</translation>
    </message>
    <message>
        <source>comes after %1 rows of readings, the limit: divide the file</source>
        <translation>位于 %1 行读数之后，已达上限：请拆分文件</translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between the entries of a list</extracomment>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 is not a number: type one such as 2405 or 2405.5</source>
        <translation>%1 不是数：请输入例如 2405 或 2405.5 的数</translation>
    </message>
    <message>
        <source>%1 is not one number: type digits with one decimal sign and nothing between them</source>
        <translation>%1 不是单个数：请只输入数字和一个小数点符号，中间不加其他字符</translation>
    </message>
    <message>
        <source>is empty: type a number</source>
        <translation>为空：请输入数</translation>
    </message>
    <message>
        <source>%1 is too large or too small to be worked with: check the exponent</source>
        <translation>%1 过大或过小，无法计算：请检查指数</translation>
    </message>
    <message>
        <source>is empty: type a whole number</source>
        <translation>为空：请输入整数</translation>
    </message>
    <message>
        <source>%1 is not a whole number: type digits alone</source>
        <translation>%1 不是整数：请只输入数字</translation>
    </message>
    <message>
        <source>%1 has more than nine digits: type a smaller number</source>
        <translation>%1 超过九位：请输入较小的数</translation>
    </message>
    <message>
        <source>horizontal step</source>
        <translation>水平阶跃</translation>
    </message>
    <message>
        <source>vertical step</source>
        <translation>竖直阶跃</translation>
    </message>
    <message>
        <source>radius along the guideway</source>
        <translation>沿导轨的半径</translation>
    </message>
    <message>
        <source>guideway out of its plane</source>
        <translation>导轨偏离其平面</translation>
    </message>
    <message>
        <source>slider readings along the scale</source>
        <translation>沿刻度的滑块读数</translation>
    </message>
    <message>
        <source>radius from place to place, turning with the guideway</source>
        <translation>半径随位置的变化，随导轨转动</translation>
    </message>
    <message>
        <source>guideway out of its plane from place to place</source>
        <translation>导轨随位置偏离其平面</translation>
    </message>
    <message>
        <source>slider readings from place to place</source>
        <translation>滑块读数随位置的变化</translation>
    </message>
    <message>
        <source>radius from place to place in each position</source>
        <translation>各轴位中半径随位置的变化</translation>
    </message>
    <message>
        <source>horizontal orientation varying with time</source>
        <translation>随时间变化的水平定向</translation>
    </message>
    <message>
        <source>vertical orientation varying with time</source>
        <translation>随时间变化的竖直定向</translation>
    </message>
    <message>
        <source>orientation varying with time</source>
        <translation>随时间变化的定向</translation>
    </message>
    <message>
        <source>orientation settling with time</source>
        <translation>随时间趋于稳定的定向</translation>
    </message>
    <message>
        <source>distance varying with time</source>
        <translation>随时间变化的距离</translation>
    </message>
    <message>
        <source>horizontal readings varying with azimuth</source>
        <translation>随方位角变化的水平读数</translation>
    </message>
    <message>
        <source>vertical readings varying with elevation</source>
        <translation>随高度角变化的竖直读数</translation>
    </message>
    <message>
        <source>horizontal readings varying with elevation</source>
        <translation>随高度角变化的水平读数</translation>
    </message>
    <message>
        <source>vertical readings varying with azimuth</source>
        <translation>随方位角变化的竖直读数</translation>
    </message>
    <message>
        <source>difference of the faces, horizontal</source>
        <translation>两盘位之差，水平</translation>
    </message>
    <message>
        <source>difference of the faces, vertical</source>
        <translation>两盘位之差，竖直</translation>
    </message>
    <message>
        <source>horizontal orientation from round to round</source>
        <translation>逐测回的水平定向</translation>
    </message>
    <message>
        <source>vertical orientation from round to round</source>
        <translation>逐测回的竖直定向</translation>
    </message>
    <message>
        <source>ratio</source>
        <extracomment>true noise over the stated</extracomment>
        <translation>比值</translation>
    </message>
    <message>
        <source>vertical angle relation</source>
        <translation>竖直角关系式</translation>
    </message>
    <message>
        <source>the vertical circle follows the other relation between height and angle (y/L instead of y/√(x²+L²), or the reverse)</source>
        <translation>竖直度盘遵循另一种高度与角度的关系（y/L 而非 y/√(x²+L²)，或相反）</translation>
    </message>
    <message>
        <source>correct the session&apos;s vertical angle relation</source>
        <translation>改正测量记录的竖直角关系式</translation>
    </message>
    <message>
        <source>share</source>
        <extracomment>how much of the effect is there</extracomment>
        <translation>份额</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>照准差</translation>
    </message>
    <message>
        <source>the line of sight is not perpendicular to the trunnion axis</source>
        <translation>视线与横轴不垂直</translation>
    </message>
    <message>
        <source>observe in both faces, or adjust the reticle</source>
        <translation>双盘位观测，或校正分划板</translation>
    </message>
    <message>
        <source>trunnion tilt</source>
        <translation>横轴误差</translation>
    </message>
    <message>
        <source>the trunnion axis is not perpendicular to the vertical axis</source>
        <translation>横轴与竖轴不垂直</translation>
    </message>
    <message>
        <source>observe in both faces</source>
        <translation>双盘位观测</translation>
    </message>
    <message>
        <source>tilt</source>
        <extracomment>the size of a tilt</extracomment>
        <translation>倾斜量</translation>
    </message>
    <message>
        <source>vertical index</source>
        <translation>竖盘指标差</translation>
    </message>
    <message>
        <source>the vertical circle has an index error</source>
        <translation>竖直度盘存在指标差</translation>
    </message>
    <message>
        <source>index</source>
        <extracomment>the error of a circle&apos;s index</extracomment>
        <translation>指标差</translation>
    </message>
    <message>
        <source>vertical axis tilt</source>
        <translation>竖轴倾斜</translation>
    </message>
    <message>
        <source>the vertical axis is not plumb</source>
        <translation>竖轴不铅垂</translation>
    </message>
    <message>
        <source>level the instrument, or switch its compensator on</source>
        <translation>整平仪器，或打开补偿器</translation>
    </message>
    <message>
        <source>tilt about x</source>
        <translation>绕 x 的倾斜</translation>
    </message>
    <message>
        <source>tilt about z</source>
        <translation>绕 z 的倾斜</translation>
    </message>
    <message>
        <source>horizontal circle eccentricity</source>
        <translation>水平度盘偏心</translation>
    </message>
    <message>
        <source>the horizontal circle is not centred on its axis</source>
        <translation>水平度盘中心与其轴不重合</translation>
    </message>
    <message>
        <source>observe in both faces, or repeat with a shifted circle</source>
        <translation>双盘位观测，或变换度盘位置重复观测</translation>
    </message>
    <message>
        <source>sine</source>
        <extracomment>the part of a wave that goes as the sine</extracomment>
        <translation>正弦项</translation>
    </message>
    <message>
        <source>cosine</source>
        <extracomment>the part of a wave that goes as the cosine</extracomment>
        <translation>余弦项</translation>
    </message>
    <message>
        <source>vertical circle eccentricity</source>
        <translation>竖直度盘偏心</translation>
    </message>
    <message>
        <source>the vertical circle is not centred on its axis</source>
        <translation>竖直度盘中心与其轴不重合</translation>
    </message>
    <message>
        <source>horizontal drift</source>
        <translation>水平漂移</translation>
    </message>
    <message>
        <source>the horizontal orientation turns steadily during the session</source>
        <translation>水平定向在测量过程中持续转动</translation>
    </message>
    <message>
        <source>observe there and back, and let the instrument settle</source>
        <translation>往返观测，并让仪器稳定</translation>
    </message>
    <message>
        <source>drift</source>
        <extracomment>how far something drifts</extracomment>
        <translation>漂移量</translation>
    </message>
    <message>
        <source>vertical drift</source>
        <translation>竖直漂移</translation>
    </message>
    <message>
        <source>the vertical orientation turns steadily during the session</source>
        <translation>竖直定向在测量过程中持续转动</translation>
    </message>
    <message>
        <source>plane tilt</source>
        <translation>平面倾斜</translation>
    </message>
    <message>
        <source>the arc plane is not perpendicular to the zero direction</source>
        <translation>圆弧平面与瞄准零位方向不垂直</translation>
    </message>
    <message>
        <source>read the slider, and determine the pointing zero again</source>
        <translation>读取滑块，并重新测定瞄准零位</translation>
    </message>
    <message>
        <source>tilt about y</source>
        <translation>绕 y 的倾斜</translation>
    </message>
    <message>
        <source>plane offset</source>
        <translation>平面偏移</translation>
    </message>
    <message>
        <source>the arc plane is offset from the rotation axis, so the distance differs between the positions</source>
        <translation>圆弧平面偏离回转轴，因此各轴位的距离不同</translation>
    </message>
    <message>
        <source>measure the distance in both positions</source>
        <translation>在两个轴位都测量距离</translation>
    </message>
    <message>
        <source>offset</source>
        <extracomment>how far something lies off</extracomment>
        <translation>偏移量</translation>
    </message>
    <message>
        <source>axial shift</source>
        <translation>轴向移动</translation>
    </message>
    <message>
        <source>the guideway moves along its axis when it is turned</source>
        <translation>导轨转动时沿其轴移动</translation>
    </message>
    <message>
        <source>sight the zero again before and after turning, and check the axial bearing</source>
        <translation>转动前后重新照准零位，并检查轴向轴承</translation>
    </message>
    <message>
        <source>shift</source>
        <extracomment>how far something shifts</extracomment>
        <translation>移动量</translation>
    </message>
    <message>
        <source>radius change</source>
        <translation>半径变化</translation>
    </message>
    <message>
        <source>the radius differs between the positions</source>
        <translation>各轴位的半径不同</translation>
    </message>
    <message>
        <source>measure the distance in both positions, and check play and temperature</source>
        <translation>在两个轴位都测量距离，并检查间隙和温度</translation>
    </message>
    <message>
        <source>change</source>
        <extracomment>how much something changes</extracomment>
        <translation>变化量</translation>
    </message>
    <message>
        <source>arc ellipticity</source>
        <translation>圆弧椭圆度</translation>
    </message>
    <message>
        <source>the guideway is elliptic</source>
        <translation>导轨呈椭圆形</translation>
    </message>
    <message>
        <source>read the slider to map the form of the guideway</source>
        <translation>读取滑块以测定导轨的形状</translation>
    </message>
    <message>
        <source>arc lobing</source>
        <translation>圆弧三棱度</translation>
    </message>
    <message>
        <source>the guideway has three lobes</source>
        <translation>导轨呈三棱形</translation>
    </message>
    <message>
        <source>gravity sag</source>
        <translation>重力下垂</translation>
    </message>
    <message>
        <source>the slider sags under its weight, whichever way the guideway is turned</source>
        <translation>滑块因自重下垂，与导轨转向无关</translation>
    </message>
    <message>
        <source>read the slider, and stiffen the guideway</source>
        <translation>读取滑块，并加强导轨刚度</translation>
    </message>
    <message>
        <source>sag</source>
        <extracomment>how far something sags</extracomment>
        <translation>下垂量</translation>
    </message>
    <message>
        <source>plane warp</source>
        <translation>平面翘曲</translation>
    </message>
    <message>
        <source>the guideway is warped out of its plane</source>
        <translation>导轨翘曲而偏离其平面</translation>
    </message>
    <message>
        <source>observe from a second stand-off</source>
        <translation>从另一测站距离观测</translation>
    </message>
    <message>
        <source>slider scale</source>
        <translation>滑块刻度比例</translation>
    </message>
    <message>
        <source>the slider&apos;s scale is stretched</source>
        <translation>滑块的刻度被拉伸</translation>
    </message>
    <message>
        <source>calibrate the slider</source>
        <translation>校准滑块</translation>
    </message>
    <message>
        <source>scale</source>
        <extracomment>how much a scale is stretched</extracomment>
        <translation>比例</translation>
    </message>
    <message>
        <source>slider eccentricity</source>
        <translation>滑块偏心</translation>
    </message>
    <message>
        <source>the slider&apos;s scale is not centred on the arc</source>
        <translation>滑块刻度中心与圆弧圆心不重合</translation>
    </message>
    <message>
        <source>setup shift</source>
        <translation>设站移动</translation>
    </message>
    <message>
        <source>the instrument or the axis is displaced between the first position and the later ones</source>
        <translation>仪器或回转轴在第一轴位与其后各轴位之间发生位移</translation>
    </message>
    <message>
        <source>fasten instrument and device to one foundation, and measure the first position again at the end</source>
        <translation>将仪器和设备固定在同一基础上，并在最后复测第一轴位</translation>
    </message>
    <message>
        <source>shift along x</source>
        <translation>沿 x 的位移</translation>
    </message>
    <message>
        <source>shift along y</source>
        <translation>沿 y 的位移</translation>
    </message>
    <message>
        <source>points repeated in the same position and face are assigned to further rounds</source>
        <translation>同一轴位和盘位中重复出现的测点归入后续测回</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 第 %2 行</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>the vertical circle is stated as %1, but the file says %2: the circle is read as the file says</source>
        <translation>竖直度盘原设为 %1，但文件中为%2：按文件读取</translation>
    </message>
    <message>
        <source>the file states the axis positions: the line given for 180° is not used</source>
        <translation>文件本身说明了轴位：指定的 180° 起始行未使用</translation>
    </message>
    <message>
        <source>the %1 %2 of the pointing zero in %3 is not used</source>
        <translation>%3中瞄准零位的 %1 %2 未使用</translation>
    </message>
    <message>
        <source>the excluded sighting of the pointing zero in %1 is not used</source>
        <translation>%1中被排除的瞄准零位照准未使用</translation>
    </message>
    <message>
        <source>lines %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>the pointing zero at %1 keeps its given value; the sighting in %2 is not used</source>
        <translation>%1 的瞄准零位保持原有值；%2的照准未使用</translation>
    </message>
    <message>
        <source>180° was read before 0°, but a session assumes 0° first: a drift or a jump between the positions would get the wrong sign</source>
        <translation>180° 先于 0° 读取，但测量记录以 0° 为先：两轴位之间的漂移或突跳的符号会相反</translation>
    </message>
    <message>
        <source>the column %1 is not used: 1 value</source>
        <translation>列 %1 未使用：1 个值</translation>
    </message>
    <message>
        <source>the column %1 is not used: %2 values</source>
        <translation>列 %1 未使用：%2 个值</translation>
    </message>
    <message>
        <source>line %1 begins with # and is not used, though it holds a reading</source>
        <translation>第 %1 行以 # 开头，虽含读数但未使用</translation>
    </message>
    <message>
        <source>%1 is a second column for “%2”: rename or remove one of the two</source>
        <translation>%1 是“%2”的第二列：请改名或删除其中之一</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>no column is named “%1”: begin with a row of names such as axis;point;face;horizontal;vertical</source>
        <translation>没有名为“%1”的列：请以列名行开头，例如 axis;point;face;horizontal;vertical</translation>
    </message>
    <message>
        <source>%1 is beyond the last named column: name its column, or put the entry that contains a separator in double quotes</source>
        <translation>%1 超出最后一个有名称的列：请为该列命名，或给含分隔符的内容加双引号</translation>
    </message>
    <message>
        <source>%1 is no turn: turns of the axis are numbered from 1</source>
        <translation>%1 不是转次：轴的转次从 1 开始</translation>
    </message>
    <message>
        <source>%1 has a decimal sign other than the one stated: state the right sign, or allow either</source>
        <translation>%1 的小数点符号与给定的不同：请给定正确的符号，或选择“任意”</translation>
    </message>
    <message>
        <source>%1 is neither yes nor no: type one of them</source>
        <translation>%1 既不是 yes 也不是 no：请输入其中之一</translation>
    </message>
    <message>
        <source>has more than %1 columns: a table of readings has about ten; save it again</source>
        <translation>超过 %1 列：读数表一般只有十列左右，请重新保存</translation>
    </message>
    <message>
        <source>the double quote is never closed: close it, or write the cell without it</source>
        <translation>双引号没有闭合：请闭合，或不用引号书写该单元格</translation>
    </message>
    <message>
        <source>further content that a session cannot hold</source>
        <translation>测量记录中无处存放的其他内容</translation>
    </message>
    <message>
        <source>%1 is not used: line %2</source>
        <translation>未使用：%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1 is not used: %2 times, first in line %3</source>
        <translation>未使用：%1，共 %2 次，首次在第 %3 行</translation>
    </message>
    <message>
        <source>%1 (and %2 more of this kind)</source>
        <translation>%1（另有 %2 处同类问题）</translation>
    </message>
    <message>
        <source>the line %1</source>
        <translation>该行 %1</translation>
    </message>
    <message>
        <source>the code block %1</source>
        <translation>代码块 %1</translation>
    </message>
    <message>
        <source>point %1 without angles</source>
        <translation>没有角度的点 %1</translation>
    </message>
    <message>
        <source>has no vertical circle (word 22): add the word or delete the line</source>
        <translation>缺少竖直度盘（字 22）：请补上该字或删除该行</translation>
    </message>
    <message>
        <source>has no horizontal circle (word 21): add the word or delete the line</source>
        <translation>缺少水平度盘（字 21）：请补上该字或删除该行</translation>
    </message>
    <message>
        <source>point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>instrument type</source>
        <translation>仪器型号</translation>
    </message>
    <message>
        <source>station</source>
        <translation>测站</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>horizontal circle</source>
        <translation>水平度盘</translation>
    </message>
    <message>
        <source>vertical circle</source>
        <translation>竖直度盘</translation>
    </message>
    <message>
        <source>difference of the horizontal circle</source>
        <translation>水平度盘读数差</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>斜距</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>平距</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>高差</translation>
    </message>
    <message>
        <source>code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>ppm and prism constant</source>
        <translation>ppm 和棱镜常数</translation>
    </message>
    <message>
        <source>number of measurements</source>
        <translation>测量次数</translation>
    </message>
    <message>
        <source>signal strength</source>
        <translation>信号强度</translation>
    </message>
    <message>
        <source>prism constant</source>
        <translation>棱镜常数</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>ppm</translation>
    </message>
    <message>
        <source>easting</source>
        <translation>东坐标</translation>
    </message>
    <message>
        <source>northing</source>
        <translation>北坐标</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高程</translation>
    </message>
    <message>
        <source>station easting</source>
        <translation>测站东坐标</translation>
    </message>
    <message>
        <source>station northing</source>
        <translation>测站北坐标</translation>
    </message>
    <message>
        <source>station height</source>
        <translation>测站高程</translation>
    </message>
    <message>
        <source>reflector height</source>
        <translation>棱镜高</translation>
    </message>
    <message>
        <source>%1 is no GSI word such as 21.102+17920860: transfer the file again, or correct or delete the line</source>
        <translation>%1 不是 21.102+17920860 那样的 GSI 字：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>%1 has neither 8 nor 16 characters of data, and a block that starts with * has 16: transfer the file again, or correct or delete the line</source>
        <translation>%1 的数据既不是 8 个也不是 16 个字符，而以 * 开头的块应为 16 个：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>%1 has neither 8 nor 16 characters of data: transfer the file again, or correct or delete the line</source>
        <translation>%1 的数据既不是 8 个也不是 16 个字符：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>has %1 words or more: transfer the file again</source>
        <translation>有 %1 个字或更多：请重新传输文件</translation>
    </message>
    <message>
        <source>is not made of digits: transfer the file again</source>
        <translation>不是由数字组成：请重新传输文件</translation>
    </message>
    <message>
        <source>is larger than a full circle: transfer the file again</source>
        <translation>大于一个整圆：请重新传输文件</translation>
    </message>
    <message>
        <source>has no angle unit: character 6 of the word is “%1”; valid are 2 (gon), 3 (decimal degrees), 4 (degrees minutes seconds), 5 (mil)</source>
        <translation>没有角度单位：该字的第 6 位为“%1”；可用 2（gon）、3（十进制度）、4（度分秒）、5（密位）</translation>
    </message>
    <message>
        <source>instrument height</source>
        <translation>仪器高</translation>
    </message>
    <message>
        <source>information %1</source>
        <translation>信息 %1</translation>
    </message>
    <message>
        <source>remark %1</source>
        <translation>备注 %1</translation>
    </message>
    <message>
        <source>word %1</source>
        <translation>字 %1</translation>
    </message>
    <message>
        <source>has its last reading in line %1, so the readings at 180° cannot begin at line %2: give a line within the file</source>
        <translation>最后一个读数在第 %1 行，因此从第 %2 行起没有 180° 的读数：请指定文件内的行</translation>
    </message>
    <message>
        <source>holds no readings with a horizontal and a vertical circle: choose another file</source>
        <translation>没有带水平度盘和竖直度盘的读数：请选择其他文件</translation>
    </message>
    <message>
        <source>has vertical readings of the kind %1, but the earlier ones are of the kind %2: a session has one kind; import this file into a separate session</source>
        <translation>含有%1类竖直度盘的读数，而之前的读数为%2类：一份测量记录只有一种，请导入到单独的测量记录</translation>
    </message>
    <message>
        <source>no file was chosen: choose one</source>
        <translation>未选择文件：请选择文件</translation>
    </message>
    <message>
        <source>the file does not state the position of the axis: all its readings are assigned to 0°</source>
        <translation>文件中没有说明轴的位置：其所有读数归入 0°</translation>
    </message>
    <message>
        <source>%1 does not have the form For M5|Adr …|PI1 …|Hz …: transfer the file again, or correct or delete the line</source>
        <translation>%1 不符合 For M5|Adr …|PI1 …|Hz … 的格式：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>is marked with e, an error of the instrument: measure the point again</source>
        <translation>标有 e，即仪器错误：请重新测量该点</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>文字 %1</translation>
    </message>
    <message>
        <source>a line without angles</source>
        <translation>没有角度的行</translation>
    </message>
    <message>
        <source>has no vertical circle (V1): let the instrument record Hz and V, or delete the line</source>
        <translation>缺少竖直度盘（V1）：请让仪器记录 Hz 和 V，或删除该行</translation>
    </message>
    <message>
        <source>has no horizontal circle (Hz): let the instrument record Hz and V, or delete the line</source>
        <translation>缺少水平度盘（Hz）：请让仪器记录 Hz 和 V，或删除该行</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>%1 is a second reading of the same circle: delete one of the two</source>
        <translation>%1 是同一度盘的第二个读数：请删除其中之一</translation>
    </message>
    <message>
        <source>%1 is neither a zenith angle (V1) nor a height angle (V3): set the instrument to one of them and record again</source>
        <translation>%1 既不是天顶距（V1）也不是高度角（V3）：请将仪器设为其中之一并重新记录</translation>
    </message>
    <message>
        <source>%1 is no angle in gon, DEG, DMS or mil: transfer the file again</source>
        <translation>%1 不是以 gon、DEG、DMS 或密位表示的角度：请重新传输文件</translation>
    </message>
    <message>
        <source>“%1” is in a file that began with the other kind of vertical angle: import the two kinds from separate files</source>
        <translation>“%1”所在的文件以另一种竖直角开头：请将两者分文件导入</translation>
    </message>
    <message>
        <source>is JSON, not a file of readings: open it as a session</source>
        <translation>不是读数文件而是 JSON：请作为测量记录打开</translation>
    </message>
    <message>
        <source>it begins with the heading of a Sokkia SDR file</source>
        <translation>它以 Sokkia SDR 文件的标题开头</translation>
    </message>
    <message>
        <source>its lines begin with For M5</source>
        <translation>其各行以 For M5 开头</translation>
    </message>
    <message>
        <source>its lines are made of words such as 21.102+17920860</source>
        <translation>其各行由 21.102+17920860 这样的字组成</translation>
    </message>
    <message>
        <source>holds no readings: choose a file of an instrument (GSI, M5, SDR) or a table</source>
        <translation>没有读数：请选择仪器文件（GSI、M5、SDR）或表格</translation>
    </message>
    <message>
        <source>blanks separate the columns</source>
        <translation>各列以空格分隔</translation>
    </message>
    <message>
        <source>commas separate the columns</source>
        <translation>各列以逗号分隔</translation>
    </message>
    <message>
        <source>no row names the columns</source>
        <translation>没有列名行</translation>
    </message>
    <message>
        <source>the first row names the columns</source>
        <translation>第一行为列名</translation>
    </message>
    <message>
        <source>row %1 names the columns</source>
        <translation>第 %1 行为列名</translation>
    </message>
    <message>
        <source>the columns are guessed from their contents: check them</source>
        <translation>各列是根据内容猜测的：请检查</translation>
    </message>
    <message>
        <source>the decimal sign is a comma</source>
        <translation>小数分隔符为逗号</translation>
    </message>
    <message>
        <source>the decimal sign is a point</source>
        <translation>小数分隔符为点</translation>
    </message>
    <message>
        <source>gon, because %1 is more than 360</source>
        <translation>gon，因为 %1 大于 360</translation>
    </message>
    <message>
        <source>gon, because the vertical readings are near 100 or 300: check the unit</source>
        <translation>gon，因为竖直读数在 100 或 300 附近：请检查单位</translation>
    </message>
    <message>
        <source>decimal degrees, because the vertical readings are near 90 or 270 and have more than 59 in the place of minutes: check the unit</source>
        <translation>十进制度，因为竖直读数在 90 或 270 附近，且分的位置上超过 59：请检查单位</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>第 %1 行第 %2 列：%3</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>a record of coordinates (08)</source>
        <translation>坐标记录（08）</translation>
    </message>
    <message>
        <source>%1 is no record of an SDR file: transfer the file again, or correct or delete the line</source>
        <translation>%1 不是 SDR 文件的记录：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>%1 is not a supported unit of angles (1: degrees, 2: gon): set the instrument to one of them and transfer again</source>
        <translation>%1 不是本程序支持的角度单位（1 为度，2 为 gon）：请将仪器设为其中之一并重新传输</translation>
    </message>
    <message>
        <source>%1 means angles that increase to the left: set the instrument to increase to the right and measure again</source>
        <translation>%1 表示角度向左增大：请将仪器设为向右并重新测量</translation>
    </message>
    <message>
        <source>a corrected mean, not a circle reading (09MC)</source>
        <translation>改正后的平均值，不是度盘读数（09MC）</translation>
    </message>
    <message>
        <source>an observation that is not raw (09%1)</source>
        <translation>非原始的观测（09%1）</translation>
    </message>
    <message>
        <source>has no horizontal reading: delete the line, or sight the point again</source>
        <translation>缺少水平读数：请删除该行，或重新照准该点</translation>
    </message>
    <message>
        <source>has no vertical reading: delete the line, or sight the point again</source>
        <translation>缺少竖直读数：请删除该行，或重新照准该点</translation>
    </message>
    <message>
        <source>%1 is no number: transfer the file again, or correct or delete the line</source>
        <translation>%1 不是数：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>is from an instrument with the other kind of vertical circle: import the jobs from separate files</source>
        <translation>来自另一种竖直度盘的仪器：请将各作业分文件导入</translation>
    </message>
    <message>
        <source>the note %1</source>
        <translation>备注 %1</translation>
    </message>
    <message>
        <source>is not a text file: choose a GSI file, or a table saved as CSV</source>
        <translation>不是文本文件：请选择 GSI 文件，或保存为 CSV 的表格</translation>
    </message>
    <message>
        <source>%1°, repeat %2</source>
        <translation>%1°，第 %2 次</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>horizontal</source>
        <extracomment>the kind of a reading, in a list: &quot;0°, point 11, horizontal&quot;</extracomment>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <extracomment>the kind of a reading, in a list: &quot;0°, point 11, vertical&quot;</extracomment>
        <translation>竖直</translation>
    </message>
    <message>
        <source>slider</source>
        <extracomment>the kind of a reading, in a list: &quot;0°, point 11, slider&quot;</extracomment>
        <translation>滑块</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>zenith</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>高度角</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be above 0 and below 1000000 mm</source>
        <translation>%1 超出范围：必须大于 0 且小于 1000000 mm</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be 0 or more and below 1000000 mm</source>
        <translation>%1 超出范围：必须不小于 0 且小于 1000000 mm</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from -1000 to below 1000, in millionths per kelvin</source>
        <translation>%1 超出范围：必须从 -1000 到小于 1000，单位为每开尔文百万分之一</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be at least 0.001 and below 3600 arcseconds</source>
        <translation>%1 超出范围：必须不小于 0.001 且小于 3600 角秒</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be 0 or more and below 3600 arcseconds</source>
        <translation>%1 超出范围：必须不小于 0 且小于 3600 角秒</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be at least -273.15 and below 1000 °C</source>
        <translation>%1 超出范围：必须不小于 -273.15 °C 且小于 1000 °C</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be 0 or more and below 1000 K</source>
        <translation>%1 超出范围：必须不小于 0 且小于 1000 K</translation>
    </message>
    <message>
        <source>is empty: type the distance from the theodolite to the arc plane in mm</source>
        <translation>为空：请输入经纬仪到圆弧平面的距离，单位 mm</translation>
    </message>
    <message>
        <source>is empty: type the nominal radius of the arc in mm</source>
        <translation>为空：请输入圆弧的标称半径，单位 mm</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be between 0 and 1, such as 0.95</source>
        <translation>%1 超出范围：必须在 0 和 1 之间，例如 0.95</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be a length in mm</source>
        <translation>%1 超出范围：必须是以 mm 表示的长度</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be below 1000000 in size</source>
        <translation>%1 超出范围：绝对值必须小于 1000000</translation>
    </message>
    <message>
        <source>is empty: type the standard uncertainty of the known size</source>
        <translation>为空：请输入已知值的标准不确定度</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be at least 0.000001 and below 1000000</source>
        <translation>%1 超出范围：必须不小于 0.000001 且小于 1000000</translation>
    </message>
    <message>
        <source>%1 lies outside %2°…%3°: check the degrees</source>
        <translation>%1 在 %2°…%3° 之外：请检查度数</translation>
    </message>
    <message>
        <source>is empty: type the rotation of the axis, 0 or 180</source>
        <translation>为空：请输入轴的转角，0 或 180</translation>
    </message>
    <message>
        <source>%1 is no position of the axis: type 0 or 180</source>
        <translation>%1 不是轴位：请输入 0 或 180</translation>
    </message>
    <message>
        <source>%1 is no unit of angles: choose dms, degrees or gon</source>
        <translation>%1 不是角度单位：请选择 dms、degrees 或 gon</translation>
    </message>
    <message>
        <source>%1 is no kind of vertical circle: choose zenith or elevation</source>
        <translation>%1 不是竖直度盘的类型：请选择 zenith 或 elevation</translation>
    </message>
    <message>
        <source>%1 is no way to sight the pointing zeros: choose each or one</source>
        <translation>%1 不是照准瞄准零位的方式：请选择 each 或 one</translation>
    </message>
    <message>
        <source>%1 is no quantity for a tolerance: choose intersection or distance</source>
        <translation>%1 不是允差所限制的量：请选择 intersection 或 distance</translation>
    </message>
    <message>
        <source>%1 is no relation for the vertical angle: choose exact or planar</source>
        <translation>%1 不是竖直角的关系式：请选择 exact 或 planar</translation>
    </message>
    <message>
        <source>%1 is no radius model: choose free, common or known</source>
        <translation>%1 不是半径的处理方式：请选择 free、common 或 known</translation>
    </message>
    <message>
        <source>%1 is no date: type year-month-day, such as 2018-01-31</source>
        <translation>%1 不是日期：请输入年-月-日，例如 2018-01-31</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <extracomment>a place in a file</extracomment>
        <translation>第 %1 行第 %2 列</translation>
    </message>
    <message>
        <source>is a duplicate key: delete one of the two</source>
        <translation>是重复的键：请删除其中之一</translation>
    </message>
    <message>
        <source>has a text of more than %1: shorten it, or keep it in a separate file</source>
        <translation>含有超过 %1 的文本：请缩短，或另存为单独的文件</translation>
    </message>
    <message>
        <source>has too large a number before %1: check its exponent</source>
        <translation>在%1之前有一个过大的数：请检查其指数</translation>
    </message>
    <message>
        <source>continues after the end of the JSON document, at %1: delete what follows</source>
        <translation>在%1处 JSON 文档已结束，其后仍有内容：请删除其后的内容</translation>
    </message>
    <message>
        <source>ends too early, at %1: the file is incomplete, restore a complete copy</source>
        <translation>在%1处过早结束：文件被截断，请恢复完整的副本</translation>
    </message>
    <message>
        <source>is not JSON at %1, at %2: look there for a missing comma, colon, bracket or quotation mark</source>
        <translation>在%1的 %2 处不是 JSON：请查看该处是否缺少逗号、冒号、括号或引号</translation>
    </message>
    <message>
        <source>is not UTF-8 text at %1: save the file with UTF-8 encoding</source>
        <translation>在%1处不是 UTF-8 文本：请以 UTF-8 编码保存文件</translation>
    </message>
    <message>
        <source>has no effect without a temperature: type the temperature, or clear the coefficient</source>
        <translation>没有温度便不起作用：请输入温度，或清除该系数</translation>
    </message>
    <message>
        <source>is stated as “one”, but the positions have different zeros: give all the same α0 and β0, or state “each”</source>
        <translation>设为 one，但各轴位的零位不同：请给所有轴位相同的 α0 和 β0，或设为 each</translation>
    </message>
    <message>
        <source>is empty, as is the whole row: type its readings or delete the row</source>
        <translation>为空，整行也为空：请输入其读数或删除该行</translation>
    </message>
    <message>
        <source>%1 lies %2° from the pointing zero, farther than the arc can be sighted: check the degrees and the face</source>
        <translation>%1 距瞄准零位 %2°，超出可照准圆弧的范围：请检查度数和盘位</translation>
    </message>
    <message>
        <source>%1 is no point: points are numbered from 0</source>
        <translation>%1 不是测点：测点从 0 开始</translation>
    </message>
    <message>
        <source>%1 is no round: rounds are numbered from 1</source>
        <translation>%1 不是测回：测回从 1 开始</translation>
    </message>
    <message>
        <source>%1 is no face: type 1 or 2</source>
        <translation>%1 不是盘位：请输入 1（盘左）或 2（盘右）</translation>
    </message>
    <message>
        <source>add the reading of the horizontal circle</source>
        <translation>请补上水平度盘读数</translation>
    </message>
    <message>
        <source>add the reading of the vertical circle</source>
        <translation>请补上竖直度盘读数</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>must be an object in braces, not %1</source>
        <translation>必须是花括号中的对象，而不是%1</translation>
    </message>
    <message>
        <source>must be %1, not %2</source>
        <extracomment>two kinds of value: &quot;a number&quot;, &quot;a list&quot;</extracomment>
        <translation>必须是%1，而不是%2</translation>
    </message>
    <message>
        <source>must be true or false, not %1</source>
        <translation>必须是 true 或 false，而不是%1</translation>
    </message>
    <message>
        <source>must be a list in square brackets, not %1</source>
        <translation>必须是方括号中的列表，而不是%1</translation>
    </message>
    <message>
        <source>is missing: %1</source>
        <extracomment>what to do about it: &quot;add the rotation of the axis, 0 or 180&quot;</extracomment>
        <translation>缺失：%1</translation>
    </message>
    <message>
        <source>is missing, so this is no session file: choose a file with &quot;format&quot;: &quot;alidade-session&quot;</source>
        <translation>缺失，因此这不是测量记录文件：请选择含 &quot;format&quot;: &quot;alidade-session&quot; 的文件</translation>
    </message>
    <message>
        <source>add &quot;version&quot;: 1</source>
        <translation>请加上 &quot;version&quot;: 1</translation>
    </message>
    <message>
        <source>must be the whole number %1, not %2</source>
        <translation>必须是整数 %1，而不是 %2</translation>
    </message>
    <message>
        <source>%1 is newer than the version this program reads (%2): open it with a newer Alidade</source>
        <translation>%1 比本程序可读的版本（%2）更新：请用更新的 Alidade 打开</translation>
    </message>
    <message>
        <source>%1 is no version of a session file: it must be %2</source>
        <translation>%1 不是测量记录文件的版本：必须是 %2</translation>
    </message>
    <message>
        <source>add the distance from the theodolite to the arc plane in mm</source>
        <translation>请补上经纬仪到圆弧平面的距离，单位 mm</translation>
    </message>
    <message>
        <source>add the nominal radius of the arc in mm</source>
        <translation>请补上圆弧的标称半径，单位 mm</translation>
    </message>
    <message>
        <source>add the reading of the direction perpendicular to the arc plane</source>
        <translation>请补上垂直于圆弧平面方向的读数</translation>
    </message>
    <message>
        <source>add the rotation of the axis, 0 or 180</source>
        <translation>请补上轴的转角，0 或 180</translation>
    </message>
    <message>
        <source>add the circle readings of the direction perpendicular to the arc plane</source>
        <translation>请补上垂直于圆弧平面方向的度盘读数</translation>
    </message>
    <message>
        <source>add the distance and the nominal radius</source>
        <translation>请补上距离和标称半径</translation>
    </message>
    <message>
        <source>add the list of the positions of the axis, which may be empty</source>
        <translation>请补上轴位列表，可以为空</translation>
    </message>
    <message>
        <source>is %1, not an object in braces: this is no session file</source>
        <translation>是%1，而不是花括号中的对象：这不是测量记录文件</translation>
    </message>
    <message>
        <source>a text in quotation marks</source>
        <translation>引号中的文本</translation>
    </message>
    <message>
        <source>an angle, a text such as &quot;341 52 24&quot; or a number of degrees</source>
        <translation>角度，即例如 &quot;341 52 24&quot; 的文本或以度表示的数</translation>
    </message>
    <message>
        <source>%1 is %2° from the first sighting of the pointing zero: check the degrees and the face</source>
        <translation>%1 距首次照准的瞄准零位 %2°：请检查度数和盘位</translation>
    </message>
    <message>
        <source>The arc&apos;s centre is Δz = %1 off the axis, perpendicular to the plane of the arc.</source>
        <translation>在垂直于圆弧平面的方向上，圆心偏离回转轴 Δz = %1。</translation>
    </message>
    <message>
        <source>has readings of 1 place; a circle needs three, and five or more for a check: sight more places</source>
        <translation>只有 1 个位置的读数；圆需要三个，要检核则需五个以上：请照准更多位置</translation>
    </message>
    <message>
        <source>has readings of %1 places; a circle needs three, and five or more for a check: sight more places</source>
        <translation>有 %1 个位置的读数；圆需要三个，要检核则需五个以上：请照准更多位置</translation>
    </message>
    <message>
        <source>has readings of only 1 distinct place, the others are repeats; a circle needs three: move the slider between the points</source>
        <translation>只有 1 个不同位置的读数，其余为重复；圆需要三个：请在各测点之间移动滑块</translation>
    </message>
    <message>
        <source>has readings of only %1 distinct places, the others are repeats; a circle needs three: move the slider between the points</source>
        <translation>只有 %1 个不同位置的读数，其余为重复；圆需要三个：请在各测点之间移动滑块</translation>
    </message>
    <message>
        <source>has readings that lie on a straight line, which determines no circle: check them, and sight places over a longer arc</source>
        <translation>的读数位于一条直线上，无法确定圆：请检查这些读数，并在更长的弧段上照准</translation>
    </message>
    <message>
        <source>spans only %1° of arc: the reading noise hides its sagitta, so radius and centre are undetermined: sight places over a longer arc</source>
        <translation>只跨越 %1° 的弧：其矢高淹没在读数噪声中，半径和圆心都无法确定：请在更长的弧段上照准</translation>
    </message>
    <message>
        <source>has readings that determine neither radius nor centre: look for misread values, the degrees first, and check the stated σ of the circles</source>
        <translation>的读数既不能确定半径也不能确定圆心：请查找误读，先查度数，并检查给定的度盘 σ</translation>
    </message>
    <message>
        <source>has readings of %1 places; the published method needs five: sight more places</source>
        <translation>有 %1 个位置的读数；已发表的方法需要五个：请照准更多位置</translation>
    </message>
    <message>
        <source>has readings for which the equations of the published method have no unique solution: sight places over a longer arc</source>
        <translation>的读数使已发表方法的方程组没有唯一解：请在更长的弧段上照准</translation>
    </message>
    <message>
        <source>has readings from which the published method finds no circle: check L, R0 and the readings</source>
        <translation>的读数无法用已发表的方法求得圆：请检查 L、R0 和读数</translation>
    </message>
    <message>
        <source>(reduced χ² %1 with %2 degrees of freedom)</source>
        <translation>（约化 χ² 为 %1，自由度 %2）</translation>
    </message>
    <message>
        <source>the fit did not converge within %1 iterations; its result is unreliable.</source>
        <translation>拟合在 %1 次迭代内未收敛；其结果不可靠。</translation>
    </message>
    <message>
        <source>Check the readings for gross errors.</source>
        <translation>请检查读数中是否有粗差。</translation>
    </message>
    <message>
        <source>the readings only just determine the circle; nothing checks them, and the uncertainty depends on the stated noise alone.</source>
        <translation>读数刚好确定圆；没有任何检核，不确定度仅依赖于给定噪声。</translation>
    </message>
    <message>
        <source>Sight more places.</source>
        <translation>请照准更多位置。</translation>
    </message>
    <message>
        <source>the readings scatter %1 times their stated noise %2.</source>
        <translation>读数的离散是给定噪声的 %1 倍%2。</translation>
    </message>
    <message>
        <source>Look for misread values or an effect missing from the model; U is scaled by the scatter.</source>
        <translation>请查找误读，或模型未包含的效应；U 已按离散放大。</translation>
    </message>
    <message>
        <source>the readings agree far better than their stated noise %1.</source>
        <translation>读数之间的一致性远好于给定噪声%1。</translation>
    </message>
    <message>
        <source>Check the stated σ, and that the readings were not copied from one another.</source>
        <translation>请检查给定的 σ，并确认读数不是互相抄录的。</translation>
    </message>
    <message>
        <source>an arc of %1° determines the radius only to u = %2 mm, and the centre hardly better.</source>
        <translation>%1° 的弧只能把半径确定到 u = %2 mm，圆心也好不了多少。</translation>
    </message>
    <message>
        <source>Sight places over a longer arc.</source>
        <translation>请在更长的弧段上照准。</translation>
    </message>
    <message>
        <source>the fitted radius %1 mm is far from the nominal %2 mm.</source>
        <translation>拟合半径 %1 mm 与标称值 %2 mm 相差很大。</translation>
    </message>
    <message>
        <source>Check the distance L and the nominal radius R0: the fitted lengths are proportional to L.</source>
        <translation>请检查距离 L 和标称半径 R0：拟合的长度与 L 成正比。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>the same pair of readings occurs twice, in rows %1.</source>
        <translation>同一对读数出现两次，见第 %1 行。</translation>
    </message>
    <message>
        <source>If a row was entered twice, exclude one: a copy makes U too small.</source>
        <translation>如果某行录入了两次，请排除其一：副本会使 U 偏小。</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>%1.</source>
        <extracomment>what an effect is, as a sentence of its own</extracomment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>with the pattern&apos;s possible effect</source>
        <translation>计入该规律可能引起的改变</translation>
    </message>
    <message>
        <source>averaged over the possible explanations</source>
        <translation>对各种可能的解释取平均</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>model effects</source>
        <translation>模型效应</translation>
    </message>
    <message>
        <source>plausible sizes</source>
        <translation>合理大小</translation>
    </message>
    <message>
        <source>known radius</source>
        <translation>已知半径</translation>
    </message>
    <message>
        <source>pointing zeros</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>other possible explanations</source>
        <translation>其他可能解释读数的原因</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>离散</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>known</source>
        <translation>已知</translation>
    </message>
    <message>
        <source>diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Δd − reference</source>
        <translation>Δd − 参考值</translation>
    </message>
    <message>
        <source>The positions do not agree: %1. A movement between them may have changed Δd: find it, or measure again with new pointing zeros.</source>
        <translation>各轴位不闭合：%1。其间的变动可能已使 Δd 改变：请找出原因，或重新测量并再次照准零位。</translation>
    </message>
    <message>
        <source> and </source>
        <translation>和</translation>
    </message>
    <message>
        <source>The result disagrees with what is known: %1. Check the known values, and find the cause of the difference.</source>
        <translation>结果与已知值不符：%1。请检查已知值，并找出两者差异的原因。</translation>
    </message>
    <message>
        <source>there are no readings; enter the readings of the axis positions</source>
        <translation>没有读数；请录入各轴位的读数</translation>
    </message>
    <message>
        <source>there is no effect “%1” in the catalogue</source>
        <translation>目录中没有效应“%1”</translation>
    </message>
    <message>
        <source>the diagnosis was stopped</source>
        <translation>诊断已停止</translation>
    </message>
    <message>
        <source>the residuals shrink from %1″ to %2″</source>
        <translation>残差由 %1″ 减小到 %2″</translation>
    </message>
    <message>
        <source>the residuals grow from %1″ to %2″</source>
        <translation>残差由 %1″ 增大到 %2″</translation>
    </message>
    <message>
        <source>the residuals stay at %1″</source>
        <translation>残差保持在 %1″</translation>
    </message>
    <message>
        <source>reduced χ² changes from %1 to %2; the unweighted residuals grow from %3″ to %4″</source>
        <translation>约化 χ² 由 %1 变为 %2；不加权的残差由 %3″ 增大到 %4″</translation>
    </message>
    <message>
        <source>reduced χ² changes from %1 to %2; the unweighted residuals stay at %3″</source>
        <translation>约化 χ² 由 %1 变为 %2；不加权的残差保持在 %3″</translation>
    </message>
    <message>
        <source>The readings scatter %1 times as much as stated, without a pattern.</source>
        <translation>读数的离散是给定值的 %1 倍，且没有规律。</translation>
    </message>
    <message>
        <source>the two positions agree, and %1</source>
        <translation>两个轴位闭合，并且%1</translation>
    </message>
    <message>
        <source>the two positions agree</source>
        <translation>两个轴位闭合</translation>
    </message>
    <message>
        <source>Without the misread values, %1.</source>
        <translation>去掉误读值后，%1。</translation>
    </message>
    <message>
        <source>With the cause in the model, %1.</source>
        <translation>计入模型后，%1。</translation>
    </message>
    <message>
        <source>With the causes in the model, %1.</source>
        <translation>一并计入模型后，%1。</translation>
    </message>
    <message>
        <source>The gap is real, and no effect of the catalogue explains it.</source>
        <translation>差距确实存在，目录中没有效应可以解释。</translation>
    </message>
    <message>
        <source>Besides %1 there is a real gap that no effect of the catalogue explains.</source>
        <translation>除%1外，差距确实存在，且目录中没有效应可以解释其余部分。</translation>
    </message>
    <message>
        <source>The gap is real, and no effect of the catalogue explains it; it follows the pattern “%1”.</source>
        <translation>差距确实存在，目录中没有效应可以解释；它遵循规律“%1”。</translation>
    </message>
    <message>
        <source>Besides %1 there is a real gap that no effect of the catalogue explains; it follows the pattern “%2”.</source>
        <translation>除%1外，差距确实存在，且目录中没有效应可以解释其余部分；它遵循规律“%2”。</translation>
    </message>
    <message>
        <source>Nothing checks the model: these readings only just determine the circles. Sight more places.</source>
        <translation>模型没有任何检核：这些读数刚好确定圆，没有多余观测。请照准更多位置。</translation>
    </message>
    <message>
        <source>The readings agree with the model within their stated noise: there is no gap to explain.</source>
        <translation>读数在给定噪声范围内与模型一致：没有需要解释的差距。</translation>
    </message>
    <message>
        <source>The gap is best explained by %1. %2</source>
        <translation>差距的最佳解释是%1。%2</translation>
    </message>
    <message>
        <source> or </source>
        <translation>或</translation>
    </message>
    <message>
        <source>The gap is best explained by several causes together: %1. %2</source>
        <translation>差距的最佳解释是多个原因共同作用：%1。%2</translation>
    </message>
    <message>
        <source>retyped</source>
        <translation>重新录入</translation>
    </message>
    <message>
        <source>suggestion accepted</source>
        <translation>采纳建议</translation>
    </message>
    <message>
        <source>cleared</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>pasted over</source>
        <translation>粘贴覆盖</translation>
    </message>
    <message>
        <source>used again</source>
        <translation>恢复使用</translation>
    </message>
    <message>
        <source>deleted</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>inserted</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>moved to another position</source>
        <translation>移到另一轴位</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>封存</translation>
    </message>
    <message>
        <source>Sealed %1 UTC by %2</source>
        <translation>%1 UTC 由 %2 封存</translation>
    </message>
    <message>
        <source>Revision %1 sealed %2 UTC by %3</source>
        <translation>修订 %1 于 %2 UTC 由 %3 封存</translation>
    </message>
    <message>
        <source>%1; one change since: the current revision is not sealed.</source>
        <translation>%1；此后有一处更改：当前修订尚未封存。</translation>
    </message>
    <message>
        <source>%1; %2 changes since: the current revision is not sealed.</source>
        <translation>%1；此后有 %2 处更改：当前修订尚未封存。</translation>
    </message>
    <message>
        <source>%1 and unchanged since.</source>
        <translation>%1，此后未更改。</translation>
    </message>
    <message>
        <source>%1; its content differs from what was sealed, and the journal does not record the change.</source>
        <translation>%1；其内容与封存时不符，而更改日志中没有记载。</translation>
    </message>
    <message>
        <source>One reading was changed after entry.</source>
        <translation>有 1 个读数在录入后被更改。</translation>
    </message>
    <message>
        <source>%1 readings were changed after entry.</source>
        <translation>有 %1 个读数在录入后被更改。</translation>
    </message>
    <message>
        <source>both faces</source>
        <translation>双盘位</translation>
    </message>
    <message>
        <source>slider readings</source>
        <translation>滑块读数</translation>
    </message>
    <message>
        <source>a second set with the horizontal circle shifted by 60°</source>
        <translation>水平度盘变换 60° 的第二组观测</translation>
    </message>
    <message>
        <source>a second set at 1.5 × the distance</source>
        <translation>在 1.5 倍距离处的第二组观测</translation>
    </message>
    <message>
        <source>more of the arc</source>
        <translation>更长的弧段</translation>
    </message>
    <message>
        <source>the pointing zero sighted again</source>
        <translation>重新照准的瞄准零位</translation>
    </message>
    <message>
        <source>the distance measured in both positions</source>
        <translation>两个轴位都测量的距离</translation>
    </message>
    <message>
        <source>0° measured again</source>
        <translation>复测 0°</translation>
    </message>
    <message>
        <source>180° measured again</source>
        <translation>复测 180°</translation>
    </message>
    <message>
        <source>%1 (in addition)</source>
        <translation>%1（补充观测）</translation>
    </message>
    <message>
        <source>%1° again</source>
        <translation>%1° 复测</translation>
    </message>
    <message>
        <source>%1° again (%2)</source>
        <translation>%1° 复测（%2）</translation>
    </message>
    <message>
        <source>The arc at %1 %2.</source>
        <translation>%1 的圆弧%2。</translation>
    </message>
    <message>
        <source>The readings of all positions do not determine the circles and the effects of the model together.</source>
        <translation>所有轴位的读数不能同时确定圆和模型效应。</translation>
    </message>
    <message>
        <source>Look for misread values, sight more places over a longer arc, or take effects out of the model.</source>
        <translation>请查找误读，在更长的弧段上照准更多位置，或从模型中去掉效应。</translation>
    </message>
    <message>
        <source>The readings of all positions do not determine the circles together.</source>
        <translation>所有轴位的读数不能共同确定圆。</translation>
    </message>
    <message>
        <source>Look for misread values, or sight more places over a longer arc.</source>
        <translation>请查找误读，或在更长的弧段上照准更多位置。</translation>
    </message>
    <message>
        <source>There is no usable position at %1°, so the intersection cannot be computed.</source>
        <translation>%1° 没有可用的轴位，因此无法计算相交度。</translation>
    </message>
    <message>
        <source>The intersection is half the distance of the arc centres at 0° and 180°: measure both positions.</source>
        <translation>相交度是 0° 和 180° 两圆心距离的一半：请测量两个轴位。</translation>
    </message>
    <message>
        <source>The radii of the one rigid arc at 0° and 180° differ by %1 mm, more than their noise allows (%2 mm at 0.1 % risk).</source>
        <translation>同一刚性圆弧在 0° 和 180° 的半径相差 %1 mm，超过其噪声所允许的范围（0.1 % 风险下为 %2 mm）。</translation>
    </message>
    <message>
        <source>Look for a cause outside the model, such as a plane off the axis.</source>
        <translation>请查找模型之外的原因，例如圆弧平面偏离回转轴。</translation>
    </message>
    <message>
        <source>Along the axis the centres at 0° and 180° differ by %1 mm, more than readings and zeros allow (%2 mm at 0.1 % risk).</source>
        <translation>沿轴方向 0° 和 180° 的圆心相差 %1 mm，超过读数和零位所允许的范围（0.1 % 风险下为 %2 mm）。</translation>
    </message>
    <message>
        <source>Look for a knock or a drift since the pointing zero, or for play along the axis.</source>
        <translation>请查找照准瞄准零位以来三脚架的碰动或漂移，或沿轴的间隙。</translation>
    </message>
    <message>
        <source>The readings disagree with the known radius of %1 mm: they shift it by %2 mm; the noise of the readings and the σ of the radius allow at most %3 mm at 0.1 % risk.</source>
        <translation>读数与已知半径 %1 mm 不符：读数使其偏移 %2 mm，而在 0.1 % 风险下读数的噪声和半径的 σ 最多允许 %3 mm。</translation>
    </message>
    <message>
        <source>Check R0, its σ and the distance, or let the radius be free.</source>
        <translation>请检查 R0、其 σ 和距离，或将半径设为自由。</translation>
    </message>
    <message>
        <source>The session&apos;s model names %1, which is no effect that can be estimated.</source>
        <translation>测量记录的模型中有 %1，它不是可以估计的效应。</translation>
    </message>
    <message>
        <source>The result is computed without it: correct the name.</source>
        <translation>结果按不含它计算：请改正其名称。</translation>
    </message>
    <message>
        <source>The known size of %1 in %2 matches no entry of the catalogue.</source>
        <translation>%1 的已知值（单位 %2）与目录中的任何量都不符。</translation>
    </message>
    <message>
        <source>The known size of %1 (%2) in %3 matches no entry of the catalogue.</source>
        <translation>%1 的 %2 的已知值（单位 %3）与目录中的任何量都不符。</translation>
    </message>
    <message>
        <source>Name the effect, its parameter (if it has two) and the unit as in the catalogue; until then its plausible size is used.</source>
        <translation>请按目录给出效应名称、（有两个量时）其中的量以及单位；在此之前采用其合理大小。</translation>
    </message>
    <message>
        <source>The model assumes that the vertical circle reads y/L, which no theodolite does.</source>
        <translation>模型认为竖直度盘读取 y/L，没有经纬仪如此读数。</translation>
    </message>
    <message>
        <source>Set the relation of the vertical angle to “exact”, unless you study the planar relation.</source>
        <translation>请将竖直角的关系式设为“精确”（exact），除非要研究平面关系式。</translation>
    </message>
    <message>
        <source>at 0° below it</source>
        <translation>0° 时在下方</translation>
    </message>
    <message>
        <source>at %1° above it</source>
        <translation>%1° 时在上方</translation>
    </message>
    <message>
        <source>the distance L (%1) and the nominal radius R0 (%2), both in mm</source>
        <translation>距离 L（%1）和标称半径 R0（%2），均以 mm 为单位</translation>
    </message>
    <message>
        <source>No theodolite sights anything at a distance of %1 mm.</source>
        <translation>没有经纬仪能在 %1 mm 的距离上照准。</translation>
    </message>
    <message>
        <source>Check %1: the fitted lengths are proportional to the distance.</source>
        <translation>请检查%1：拟合的长度与距离成正比。</translation>
    </message>
    <message>
        <source>Most places lie on the wrong side of the fitted centre, %1: they should be above it at 0° and below it at 180°. Δd may have the wrong sign.</source>
        <translation>大多数位置位于拟合圆心的错误一侧，%1：0° 时应在圆心上方，180° 时应在下方。Δd 的符号可能有误。</translation>
    </message>
    <message>
        <source>Check the kind of the vertical circle, and whether the positions are exchanged.</source>
        <translation>请检查竖直度盘的类型，以及轴位是否互换。</translation>
    </message>
    <message>
        <source>Check the axis of this position, its pointing zero and its readings.</source>
        <translation>请检查该轴位的轴角、瞄准零位和读数。</translation>
    </message>
    <message>
        <source>The pointing zero at %1 has %2° on the vertical circle, far from the horizon of a zenith circle, which reads 90° there.</source>
        <translation>%1 的瞄准零位在竖直度盘上为 %2°，远离天顶距度盘的水平线（该处读数为 90°）。</translation>
    </message>
    <message>
        <source>Check the kind of the vertical circle: on an elevation circle its readings grow the other way, and Δd changes its sign.</source>
        <translation>请检查竖直度盘的类型：若为高度角度盘，其读数方向相反，Δd 的符号随之改变。</translation>
    </message>
    <message>
        <source>The pointing zero at %1 has %2° on the vertical circle, far from the horizon of an elevation circle, which reads 0° there.</source>
        <translation>%1 的瞄准零位在竖直度盘上为 %2°，远离高度角度盘的水平线（该处读数为 0°）。</translation>
    </message>
    <message>
        <source>Check the kind of the vertical circle: on a zenith circle its readings grow the other way, and Δd changes its sign.</source>
        <translation>请检查竖直度盘的类型：若为天顶距度盘，其读数方向相反，Δd 的符号随之改变。</translation>
    </message>
    <message>
        <source>%1: rows %2 and %3 are of one visit, yet their slider values differ by %4″; only the first is used, here and in %5 more cases.</source>
        <translation>%1：第 %2 行和第 %3 行属于同一次停靠，但滑块值相差 %4″；此处及另外 %5 处只使用第一个。</translation>
    </message>
    <message>
        <source>%1: rows %2 and %3 are of one visit, yet their slider values differ by %4″; only the first is used.</source>
        <translation>%1：第 %2 行和第 %3 行属于同一次停靠，但滑块值相差 %4″；只使用第一个。</translation>
    </message>
    <message>
        <source>The slider stands still during a visit: correct the value, or give the rows different points or rounds.</source>
        <translation>一次停靠中滑块静止不动：请改正该值，或给各行不同的测点或测回。</translation>
    </message>
    <message>
        <source>All positions have the same pointing zero. If it was sighted once, its error cancels in Δd; if it was sighted in each position, equal readings are unlikely.</source>
        <translation>所有轴位的瞄准零位相同：若只照准一次，其误差处处相同，在 Δd 中抵消；若各自照准，读数几乎不可能一样。</translation>
    </message>
    <message>
        <source>Both positions have the same pointing zero. If it was sighted once, its error cancels in Δd; if it was sighted in each position, equal readings are unlikely.</source>
        <translation>两个轴位的瞄准零位相同：若只照准一次，其误差处处相同，在 Δd 中抵消；若各自照准，读数几乎不可能一样。</translation>
    </message>
    <message>
        <source>State under “Pointing zeros” which of the two is true.</source>
        <translation>请在“瞄准零位”中注明属于哪种情况。</translation>
    </message>
    <message>
        <source>%1: the pointing zero moved by %2 horizontally and %3 vertically (1σ) while the position was read.</source>
        <translation>%1：读取该轴位期间，瞄准零位水平移动 %2，竖直移动 %3（1σ）。</translation>
    </message>
    <message>
        <source>Look for a knock of the tripod or an orientation that drifts, and observe the position again.</source>
        <translation>请查找三脚架的碰动或定向的漂移，并重新观测该轴位。</translation>
    </message>
    <message>
        <source>%1: the sightings of the pointing zero in face 2 are left out, since not every position has one: collimation and index would not cancel.</source>
        <translation>%1：盘右的瞄准零位照准未采用，因为并非每个轴位都有：照准差和指标差无法抵消。</translation>
    </message>
    <message>
        <source>Sight the zeros of all positions in both faces.</source>
        <translation>请在双盘位照准所有轴位的零位。</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>测点 %1</translation>
    </message>
    <message>
        <source>round %1</source>
        <translation>测回 %1</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>盘位 %1</translation>
    </message>
    <message>
        <source>two digits swapped</source>
        <translation>两位数字颠倒</translation>
    </message>
    <message>
        <source>one digit wrong</source>
        <translation>一位数字错误</translation>
    </message>
    <message>
        <source>one degree off</source>
        <translation>差一度</translation>
    </message>
    <message>
        <source>ten minutes off</source>
        <translation>差十分</translation>
    </message>
    <message>
        <source>one minute off</source>
        <translation>差一分</translation>
    </message>
    <message>
        <source>ten seconds off</source>
        <translation>差十秒</translation>
    </message>
    <message>
        <source>the two circles swapped</source>
        <translation>两个度盘互换</translation>
    </message>
    <message>
        <source>the wrong face</source>
        <translation>盘位错误</translation>
    </message>
    <message>
        <source>swapped with the neighbouring row</source>
        <translation>与相邻行互换</translation>
    </message>
    <message>
        <source>%1 of row %2</source>
        <translation>第 %2 行的%1</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>（空）</translation>
    </message>
    <message>
        <source>%1: %2; the residual becomes %3.</source>
        <translation>%1：%2；改正后残差为 %3。</translation>
    </message>
    <message>
        <source>off by %1</source>
        <translation>偏差 %1</translation>
    </message>
    <message>
        <source>not an angle</source>
        <translation>不是角度</translation>
    </message>
    <message>
        <source>%1: %2. Probably meant: %3</source>
        <translation>%1：%2。可能应为：%3</translation>
    </message>
    <message>
        <source>; </source>
        <translation>；</translation>
    </message>
    <message>
        <source>A reading looks misread: %1.</source>
        <translation>有一个读数像是误读：%1。</translation>
    </message>
    <message>
        <source>%1 readings look misread: %2.</source>
        <translation>有 %1 个读数像是误读：%2。</translation>
    </message>
    <message>
        <source>Check it in the field book, then correct or exclude it; until then every usable reading takes part in the result.</source>
        <translation>请对照手簿检查，然后改正或排除；在此之前所有可用读数都参与计算。</translation>
    </message>
    <message>
        <source>Check them in the field book, then correct or exclude them; until then every usable reading takes part in the result.</source>
        <translation>请对照手簿检查，然后改正或排除；在此之前所有可用读数都参与计算。</translation>
    </message>
    <message>
        <source>The verdict is withheld: no theodolite sights anything at a distance of %1 mm. Check %2.</source>
        <translation>暂不判定：没有经纬仪能在 %1 mm 的距离上照准。请检查%2。</translation>
    </message>
    <message>
        <source>The verdict is withheld: the radius fitted at %1 differs from the nominal one by %2 %. Check %3.</source>
        <translation>暂不判定：%1 的拟合半径与标称值相差 %2 %。请检查%3。</translation>
    </message>
    <message>
        <source>the tolerance of ± %1 mm</source>
        <translation>允差（± %1 mm）</translation>
    </message>
    <message>
        <source>%1 (%2 % coverage)</source>
        <translation>%1（包含概率 %2 %）</translation>
    </message>
    <message>
        <source>within %1</source>
        <translation>在%1之内</translation>
    </message>
    <message>
        <source>outside %1</source>
        <translation>在%1之外</translation>
    </message>
    <message>
        <source>not clearly within or outside %1</source>
        <translation>不能明确判断是否在%1之内</translation>
    </message>
    <message>
        <source>Add the effects found to the model, or measure what the diagnosis advises.</source>
        <translation>请将所发现的效应加入模型，或按诊断的建议测量。</translation>
    </message>
    <message>
        <source>it</source>
        <translation>该允差</translation>
    </message>
    <message>
        <source>more than 99.9 %</source>
        <translation>大于 99.9 %</translation>
    </message>
    <message>
        <source>less than 0.1 %</source>
        <translation>小于 0.1 %</translation>
    </message>
    <message>
        <source>There is no verdict at a coverage of %1 %: state a coverage of %2 or more.</source>
        <translation>包含概率为 %1 % 时不作判定：请将包含概率设为 %2 或更大。</translation>
    </message>
    <message>
        <source>there are no readings to export; enter the readings of the axis positions</source>
        <translation>没有可导出的读数；请录入各轴位的读数</translation>
    </message>
    <message>
        <source>the picture cannot be made: make the window smaller</source>
        <translation>无法生成图片：请缩小窗口</translation>
    </message>
    <message>
        <source>There is nothing to compare yet: type the distance L, the radius R0, a pointing zero and at least three readings of its arc.</source>
        <translation>尚无可比较的内容：请输入距离 L、半径 R0、一个瞄准零位和该圆弧的至少三个读数。</translation>
    </message>
    <message>
        <source>These readings only just determine the arc. Type further readings: each of them checks the model.</source>
        <translation>这些读数刚好确定圆弧。请录入更多读数：每增加一个读数都能检核模型。</translation>
    </message>
    <message>
        <source>is not a file of unsaved changes</source>
        <translation>不是未保存更改的文件</translation>
    </message>
    <message>
        <source>There is no sample of this name</source>
        <translation>没有此名称的示例</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>a division of the readings and its parts: &quot;belongs to: guideway (80 %), noise (20 %)&quot;
----------
a name and what it is: &quot;Δd: not determined by these readings&quot;
----------
a sentence and what it rests on: &quot;… (72 %): the radii differ by 13 σ&quot;
----------
a number of an effect and its size: &quot;tilt about x: 12.0″ (u 1.5)&quot;
----------
title of a column and its cell: &quot;indistinguishable: gravity sag&quot;</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 is no distance: type a length in metres, or leave it empty</source>
        <translation>%1 不是距离：请录入以米为单位的长度，或留空</translation>
    </message>
    <message>
        <source>the station %1</source>
        <translation>测站 %1</translation>
    </message>
    <message>
        <source>gon</source>
        <translation>gon</translation>
    </message>
    <message>
        <source>decimal degrees</source>
        <translation>十进制度</translation>
    </message>
    <message>
        <source>degrees.minutes seconds</source>
        <translation>度.分秒</translation>
    </message>
    <message>
        <source>%1 (and %2 more)</source>
        <translation>%1（另有 %2 处）</translation>
    </message>
    <message>
        <source>has angles without a unit, and no single unit lets both faces add up to a full turn: put the unit into the column names, such as “horizontal [gon]”, or choose it (--unit)</source>
        <translation>其角度为不带单位的数，且没有唯一一种单位能使两个盘位之和为整周：请在列名中注明单位，如“horizontal [gon]”，或另行选定（--unit）</translation>
    </message>
    <message>
        <source>numbers without a unit are read as %1, since the vertical readings of both faces then add up to a full turn</source>
        <translation>不带单位的数按“%1”处理，因为这样两个盘位的竖直读数之和为整周</translation>
    </message>
    <message>
        <source>the vertical readings are treated as elevations, because they are near 0° and 180°</source>
        <translation>竖直读数按高度角处理，因为它们在 0° 和 180° 附近</translation>
    </message>
    <message>
        <source>excluded rows, not used: %1</source>
        <translation>不参与的已排除行：%1</translation>
    </message>
    <message>
        <source>has no target: enter its name</source>
        <translation>没有目标：请录入目标名称</translation>
    </message>
    <message>
        <source>rows whose stated face contradicts their vertical circle: %1; the circle is used</source>
        <translation>所注盘位与竖直度盘所示不同的行：%1；以度盘为准</translation>
    </message>
    <message>
        <source>Station %1: %2</source>
        <translation>测站 %1：%2</translation>
    </message>
    <message>
        <source>Targets missing from most rounds are not used: %1.</source>
        <translation>大多数测回都缺少的目标不参与：%1。</translation>
    </message>
    <message>
        <source>Sighted in one face only and not used: %1.</source>
        <translation>只在一个盘位观测，无法使用：%1。</translation>
    </message>
    <message>
        <source>Sighted several times in one face of a round, and averaged: %1.</source>
        <translation>一个测回的同一盘位内多次观测，取平均：%1。</translation>
    </message>
    <message>
        <source>%1 (lacks %2)</source>
        <translation>%1（缺少 %2）</translation>
    </message>
    <message>
        <source>Rounds without both faces of every target are not used: %1.</source>
        <translation>缺少某目标双盘位观测的测回不参与：%1。</translation>
    </message>
    <message>
        <source>%1 in round %2</source>
        <translation>第 %2 测回的 %1</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1，另有 %2 处</translation>
    </message>
    <message>
        <source>There is no complete round, with each target in both faces.</source>
        <translation>没有完整的测回，即每个目标都有双盘位观测。</translation>
    </message>
    <message>
        <source>Sight every target in face 1 and in face 2, and give it the same name in both.</source>
        <translation>请在盘左和盘右都观测每个目标，并使用相同的名称。</translation>
    </message>
    <message>
        <source>One complete round shows collimation and index, but not how far readings scatter.</source>
        <translation>一个完整的测回能显示照准差和指标差，但不能显示读数的离散。</translation>
    </message>
    <message>
        <source>Observe three rounds or more.</source>
        <translation>请观测三个或更多测回。</translation>
    </message>
    <message>
        <source>With one target, the scatter of directions is unknown; only the vertical circle is checked.</source>
        <translation>只有一个目标时，方向的离散未知；只检查竖直度盘。</translation>
    </message>
    <message>
        <source>Sight four targets or more, spread around the horizon.</source>
        <translation>请观测四个或更多分布于四周的目标。</translation>
    </message>
    <message>
        <source>ISO 17123-3 requires at least three rounds to four targets; with %1 degrees of freedom, s of a direction is only a rough figure.</source>
        <translation>ISO 17123-3 要求至少三个测回、四个目标；自由度为 %1 时，方向的 s 只是粗略值。</translation>
    </message>
    <message>
        <source>All rounds are identical: s is 0.</source>
        <translation>所有测回完全相同：s 为 0。</translation>
    </message>
    <message>
        <source>Check whether one round was entered several times.</source>
        <translation>请检查是否把一个测回录入了多次。</translation>
    </message>
    <message>
        <source>The index of %1 differs from zero by more than its scatter (%2): correct readings in a single face for this index.</source>
        <translation>指标差 %1 与零之差超过其离散（%2）：请对单盘位读数加指标差改正。</translation>
    </message>
    <message>
        <source>All targets lie at about the same elevation (%1° to %2°): a tilt of the trunnion axis is indistinguishable from collimation.</source>
        <translation>所有目标的高度角大致相同（%1° 至 %2°）：横轴误差无法与照准差区分。</translation>
    </message>
    <message>
        <source>Sight a steep target as well.</source>
        <translation>请另外观测一个较陡的目标。</translation>
    </message>
    <message>
        <source>A tilt of the trunnion axis is indistinguishable from collimation here: with elevations from %2° to %3°, a tilt of 30″ amounts to only %1 standard uncertainties.</source>
        <translation>横轴误差在此无法与照准差区分：高度角为 %2° 至 %3° 时，30″ 的横轴误差只相当于 %1 个标准不确定度。</translation>
    </message>
    <message>
        <source>The trunnion axis is tilted by %1 (%2); corrected for this tilt, the collimation is %3.</source>
        <translation>横轴误差为 %1（%2）；计入后照准差为 %3。</translation>
    </message>
    <message>
        <source>Not all distances are known. An offset e of the line of sight from the axis shows as e/D, which at short distances looks like collimation: half a millimetre is 43″ at 2.4 m and 2″ at 50 m.</source>
        <translation>并非所有距离都已知。视线偏离竖轴 e 时表现为 e/D，在短距离处看起来像照准差：半毫米在 2.4 m 处为 43″，在 50 m 处为 2″。</translation>
    </message>
    <message>
        <source>All targets are at about the same distance. An offset e of the line of sight from the axis shows as e/D and looks like collimation: half a millimetre is %1 at %2.</source>
        <translation>所有目标的距离大致相同。视线偏离竖轴 e 时表现为 e/D，看起来像照准差：半毫米在 %2 处为 %1。</translation>
    </message>
    <message>
        <source>Sight targets at other distances as well.</source>
        <translation>请另外观测其他距离的目标。</translation>
    </message>
    <message>
        <source>The difference of the faces is proportional to 1/D: the line of sight is %1 (%2) off the axis, which looks like a collimation of %3 at %4. Corrected for this offset, the collimation is %5.</source>
        <translation>两个盘位之差与 1/D 成正比：视线偏离竖轴 %1（%2），在 %4 处看起来像 %3 的照准差。除去后照准差为 %5。</translation>
    </message>
    <message>
        <source>An offset e of the line of sight from the axis shows as e/D and looks like collimation. These distances (%1 to %2) cannot separate the two: half a millimetre, %3 at the nearest target, amounts to only %4 standard uncertainties.</source>
        <translation>视线偏离竖轴 e 时表现为 e/D，看起来像照准差；这些距离（%1 至 %2）无法区分：半毫米在最近目标处为 %3，只相当于 %4 个标准不确定度。</translation>
    </message>
    <message>
        <source>The difference of the faces does not depend significantly on the distance: the line of sight is %1 off the axis.</source>
        <translation>两个盘位之差不随距离显著变化：视线偏离竖轴 %1。</translation>
    </message>
    <message>
        <source>The circle was reset between rounds, so a drift of the orientation between them does not show.</source>
        <translation>测回之间重新设置了度盘，因此测回间定向的漂移无从显示。</translation>
    </message>
    <message>
        <source>The orientation drifts by %1 a round (%2).</source>
        <translation>定向每测回漂移 %1（%2）。</translation>
    </message>
    <message>
        <source>The collimation drifts by %1 a round (%2).</source>
        <translation>照准差每测回漂移 %1（%2）。</translation>
    </message>
    <message>
        <source>The index drifts by %1 a round (%2).</source>
        <translation>指标差每测回漂移 %1（%2）。</translation>
    </message>
    <message>
        <source>s of a direction is not the same at stations %1 and %2 (F test, %3).</source>
        <translation>测站 %1 与 %2 的方向 s 不相同（F 检验，%3）。</translation>
    </message>
    <message>
        <source>s of a direction at station %1 differs from that of the others (F test, %2).</source>
        <translation>测站 %1 的方向 s 与其他测站不同（F 检验，%2）。</translation>
    </message>
    <message>
        <source>s of a zenith angle is not the same at stations %1 and %2 (F test, %3).</source>
        <translation>测站 %1 与 %2 的天顶距 s 不相同（F 检验，%3）。</translation>
    </message>
    <message>
        <source>s of a zenith angle at station %1 differs from that of the others (F test, %2).</source>
        <translation>测站 %1 的天顶距 s 与其他测站不同（F 检验，%2）。</translation>
    </message>
    <message>
        <source>The collimation differs between stations by more than its scatter (%1): the collimation has changed, or an indistinguishable effect has.</source>
        <translation>照准差在测站之间的差异超过其离散（%1）：照准差发生了变化，或与其无法区分的效应发生了变化。</translation>
    </message>
    <message>
        <source>The index differs between stations by more than its scatter (%1): the index changed.</source>
        <translation>指标差在测站之间的差异超过其离散（%1）：指标差发生了变化。</translation>
    </message>
    <message>
        <source>s of a direction, %1, is not significantly larger than the stated %2 (χ² test, 95 %: s up to %3 with %4 degrees of freedom).</source>
        <translation>方向的 s 为 %1，不显著大于给定的 %2（χ² 检验，95 %：自由度为 %4 时 s 可达 %3）。</translation>
    </message>
    <message>
        <source>s of a direction, %1, is significantly larger than the stated %2 (χ² test, 95 %: s up to %3 with %4 degrees of freedom).</source>
        <translation>方向的 s 为 %1，显著大于给定的 %2（χ² 检验，95 %：自由度为 %4 时 s 可达 %3）。</translation>
    </message>
    <message>
        <source>s of a zenith angle, %1, is not significantly larger than the stated %2 (χ² test, 95 %: s up to %3 with %4 degrees of freedom).</source>
        <translation>天顶距的 s 为 %1，不显著大于给定的 %2（χ² 检验，95 %：自由度为 %4 时 s 可达 %3）。</translation>
    </message>
    <message>
        <source>s of a zenith angle, %1, is significantly larger than the stated %2 (χ² test, 95 %: s up to %3 with %4 degrees of freedom).</source>
        <translation>天顶距的 s 为 %1，显著大于给定的 %2（χ² 检验，95 %：自由度为 %4 时 s 可达 %3）。</translation>
    </message>
    <message>
        <source>is missing, so this is no instrument record: choose a file with &quot;format&quot;: &quot;alidade-instrument&quot;</source>
        <translation>缺失，因此这不是仪器档案：请选择含 &quot;format&quot;: &quot;alidade-instrument&quot; 的文件</translation>
    </message>
    <message>
        <source>choose an instrument record</source>
        <translation>请选择仪器档案</translation>
    </message>
    <message>
        <source>%1 is no version of an instrument record: it must be %2</source>
        <translation>%1 不是仪器档案的版本：必须是 %2</translation>
    </message>
    <message>
        <source>is empty: enter the day it was determined, as year-month-day</source>
        <translation>为空：请写明得出这些内容的日期，格式为年-月-日</translation>
    </message>
    <message>
        <source>is empty: say which effect is known, such as collimation</source>
        <translation>为空：请写明已知的是哪个效应，例如 collimation</translation>
    </message>
    <message>
        <source>add the day it was determined</source>
        <translation>请补上得出这些内容的日期</translation>
    </message>
    <message>
        <source>%1 is not &quot;%2&quot;: %3</source>
        <extracomment>what the file says, what it should say, and what to do: &quot;choose a session file&quot;</extracomment>
        <translation>%1 不是 &quot;%2&quot;：%3</translation>
    </message>
    <message>
        <source>is not &quot;%1&quot;: %2</source>
        <translation>不是 &quot;%1&quot;：%2</translation>
    </message>
    <message>
        <source>is nested more than %1 levels deep: this is no file of this program</source>
        <translation>嵌套超过 %1 层：这不是本程序的文件</translation>
    </message>
    <message>
        <source>holds more than %1 values besides its rows of readings: this is no file of this program</source>
        <translation>除读数行外含有超过 %1 个值：这不是本程序的文件</translation>
    </message>
    <message>
        <source>is empty: choose another file</source>
        <translation>为空：请选择其他文件</translation>
    </message>
    <message>
        <source>choose a session file</source>
        <translation>请选择测量记录文件</translation>
    </message>
    <message>
        <source>%1 is not the serial number in the instrument record (%2): choose the record of this instrument, or correct the serial number</source>
        <extracomment>two serial numbers in quotation marks</extracomment>
        <translation>%1 不是仪器档案中的序列号（%2）：请选择这台仪器的档案，或更正序列号</translation>
    </message>
    <message>
        <source>The known sizes (%1) explain the gap: with them %2, and the rest is within the stated noise.</source>
        <extracomment>effects, then &quot;the residuals shrink from 12.0″ to 2.0″&quot;</extracomment>
        <translation>已知值（%1）说明了差距：计入后%2，其余在给定噪声之内。</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>an effect and which of its numbers: &quot;plane tilt, tilt about x&quot;</extracomment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>what is known beforehand</source>
        <translation>事先已知的内容</translation>
    </message>
    <message>
        <source>If the known size of %1 were out of date, these readings could not distinguish this from %2.</source>
        <translation>假如%1的已知值已过时，这些读数也无法将其与%2区分。</translation>
    </message>
    <message>
        <source>%1 is no date: write year-month-day, year-month, a year or a decimal year</source>
        <translation>%1 不是日期：请写年-月-日、年-月、年份或小数年份</translation>
    </message>
    <message>
        <source>p &lt; 0.001</source>
        <translation>p &lt; 0.001</translation>
    </message>
    <message>
        <source>p = %1</source>
        <translation>p = %1</translation>
    </message>
    <message>
        <source>There is only one value: it cannot be compared.</source>
        <translation>只有一个值：无法比较。</translation>
    </message>
    <message>
        <source>χ² = %1 with %2 degrees of freedom, %3</source>
        <translation>χ² = %1，自由度 %2，%3</translation>
    </message>
    <message>
        <source>%1: the values agree within their uncertainties, yet their course over time shows a change.</source>
        <translation>%1：各值在其不确定度内一致，但其随时间的走势仍显示出变化。</translation>
    </message>
    <message>
        <source>%1: the values agree within their uncertainties.</source>
        <translation>%1：各值在其不确定度内一致。</translation>
    </message>
    <message>
        <source>%1: the values scatter about one mean %2 times as much as their uncertainties say.</source>
        <translation>%1：各值围绕同一均值的离散是其不确定度所示的 %2 倍。</translation>
    </message>
    <message>
        <source>%1 The change happened between %2 and %3.</source>
        <translation>%1变化发生在 %2 与 %3 之间。</translation>
    </message>
    <message>
        <source>%1 The first value after the change is one of those from %2 to %3 (95 %).</source>
        <translation>%1变化后的第一个值在 %2 至 %3 之间（95 %）。</translation>
    </message>
    <message>
        <source>Neither a step nor a trend explains this scatter: the uncertainties are understated, or the values are too few to show what changed.</source>
        <translation>阶跃和趋势都不能解释这种离散：或者不确定度被低估，或者值太少，无法说明什么改变了。</translation>
    </message>
    <message>
        <source>A level with only one value may be an outlier: measure once more before acting on it.</source>
        <translation>只含一个值的阶段可能是离群值：采取措施前请再测一次。</translation>
    </message>
    <message>
        <source>The value of %1 is an outlier: look for what was different that day, such as a misread value or another set-up, before assuming a change.</source>
        <translation>%1 的值是离群值：在认定发生变化之前，请查找当天有何不同，例如误读或另一次架设。</translation>
    </message>
    <message>
        <source>The values wander: values close in time agree better than distant ones, and neither steps nor a trend explain the values equally well.</source>
        <translation>各值在游走：时间相近的比相距远的更一致，而阶跃和趋势都不能同样好地解释。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>a cause and its probability: &quot;plane offset (72 %)&quot;</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Probability of each explanation of the values: %1.</source>
        <translation>各种解释的概率：%1。</translation>
    </message>
    <message>
        <source>There is one session: it cannot be compared.</source>
        <translation>只有一份测量记录：无法比较。</translation>
    </message>
    <message>
        <source>Δd has changed between %1 and %2 by %3, %4.</source>
        <translation>从 %1 到 %2，Δd 改变了 %3，%4。</translation>
    </message>
    <message>
        <source>No change of Δd is detectable between %1 and %2: the difference is %3, %4.</source>
        <translation>从 %1 到 %2 看不出 Δd 的变化：差为 %3，%4。</translation>
    </message>
    <message>
        <source>%1 (T = %2 from %3 quantities, %4)</source>
        <translation>%1（T = %2，共 %3 个量，%4）</translation>
    </message>
    <message>
        <source>From the readings alone, the device shows no change: (O1 − O2)/2 and the radii agree.</source>
        <translation>仅从读数看，设备没有变化：(O1 − O2)/2 和半径一致。</translation>
    </message>
    <message>
        <source>From the readings alone, the device shows a change: (O1 − O2)/2 or the radii differ.</source>
        <translation>仅从读数看，设备显示有变化：(O1 − O2)/2 或半径不同。</translation>
    </message>
    <message>
        <source>O1 and O2 have not moved relative to the theodolite.</source>
        <translation>O1 和 O2 相对于经纬仪没有移动。</translation>
    </message>
    <message>
        <source>O1 and O2 have moved relative to the theodolite, as they do after every new set-up.</source>
        <translation>O1 和 O2 相对于经纬仪发生了移动；重新架设后总是如此。</translation>
    </message>
    <message>
        <source>O1, x</source>
        <translation>O1，x</translation>
    </message>
    <message>
        <source>O1, y</source>
        <translation>O1，y</translation>
    </message>
    <message>
        <source>O2, x</source>
        <translation>O2，x</translation>
    </message>
    <message>
        <source>O2, y</source>
        <translation>O2，y</translation>
    </message>
    <message>
        <source>radius at 0°</source>
        <translation>0° 的半径</translation>
    </message>
    <message>
        <source>radius at 180°</source>
        <translation>180° 的半径</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>恒定</translation>
    </message>
    <message>
        <source>in steps</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>a trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>wandering</source>
        <translation>游走</translation>
    </message>
    <message>
        <source>%1 has no date and is not used: enter the day of the measurement</source>
        <translation>%1 没有日期，不参与：请录入测量日期</translation>
    </message>
    <message>
        <source>holds no value: each line has a date, a value and its standard uncertainty</source>
        <translation>不含任何值：每行应有日期、值及其标准不确定度</translation>
    </message>
    <message>
        <source>has commas between and within its numbers: separate the numbers by semicolons</source>
        <translation>数之间和数内都有逗号：请用分号分隔</translation>
    </message>
    <message>
        <source>has no date: write year-month-day, year-month, a year or a decimal year</source>
        <translation>没有日期：请写年-月-日、年-月、年份或小数年份</translation>
    </message>
    <message>
        <source>has no value: each line has a date, a value and its standard uncertainty</source>
        <translation>没有值：每行应有日期、值及其标准不确定度</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 不是数</translation>
    </message>
    <message>
        <source>has no standard uncertainty, so the value cannot be weighted: enter the uncertainty in the third column</source>
        <translation>没有标准不确定度，因此无法对该值加权：请将不确定度写在第三列</translation>
    </message>
    <message>
        <source>the standard uncertainty %1 is not greater than 0: the value cannot be weighted</source>
        <translation>标准不确定度 %1 不大于 0：无法对该值加权</translation>
    </message>
    <message>
        <source>%1 is out of range: values reach up to 1e30, uncertainties from 1e-30 to 1e30</source>
        <translation>%1 超出范围：数值的绝对值不超过 1e30，不确定度在 1e-30 到 1e30 之间</translation>
    </message>
    <message>
        <source>the other sessions of the series</source>
        <translation>系列中的其余测量记录</translation>
    </message>
    <message>
        <source>%1 of instrument %2</source>
        <translation>仪器 %2 的%1</translation>
    </message>
    <message>
        <source>%1 of guideway %2</source>
        <translation>导轨 %2 的%1</translation>
    </message>
    <message>
        <source>%1, with its own size in each session</source>
        <translation>%1，各测量记录中大小不同</translation>
    </message>
    <message>
        <source>The size of %1 changes from session to session.</source>
        <translation>%1的大小随测量记录而变。</translation>
    </message>
    <message>
        <source>The sessions cannot distinguish %1 from %2.</source>
        <translation>这些测量记录无法区分%1与%2。</translation>
    </message>
    <message>
        <source>an instrument without serial number</source>
        <translation>无序列号的仪器</translation>
    </message>
    <message>
        <source>instrument %1</source>
        <translation>仪器 %1</translation>
    </message>
    <message>
        <source>a guideway without serial number</source>
        <translation>无序列号的导轨</translation>
    </message>
    <message>
        <source>guideway %1</source>
        <translation>导轨 %1</translation>
    </message>
    <message>
        <source>the session by itself</source>
        <translation>该测量记录自身</translation>
    </message>
    <message>
        <source>each session by itself</source>
        <translation>各测量记录自身</translation>
    </message>
    <message>
        <source>%1 alone shows %2.</source>
        <translation>%1自身含有%2。</translation>
    </message>
    <message>
        <source>%1 of %2 sessions do not state the serial number of their instrument: no instrument effect is assumed to be common to them.</source>
        <translation>%2 份测量记录中有 %1 份未注明仪器序列号：不视其共有任何仪器效应。</translation>
    </message>
    <message>
        <source>Enter the serial numbers.</source>
        <translation>请录入序列号。</translation>
    </message>
    <message>
        <source>%1 of %2 sessions do not state the serial number of their guideway: no guideway effect is assumed to be common to them.</source>
        <translation>%2 份测量记录中有 %1 份未注明导轨序列号：不视其共有任何导轨效应。</translation>
    </message>
    <message>
        <source>%2 has another size in %1 than in the other sessions.</source>
        <translation>%2在%1中的大小与在其余测量记录中不同。</translation>
    </message>
    <message>
        <source>See what was different in that session.</source>
        <translation>请查看该测量记录有何不同。</translation>
    </message>
    <message>
        <source>The sessions (%1) share no effect that shows beyond their stated noise.</source>
        <translation>这些测量记录（共 %1 份）没有共有的、超出给定噪声的效应。</translation>
    </message>
    <message>
        <source>The sessions (%1) together are best explained by %2.</source>
        <translation>这些测量记录（共 %1 份）合起来的最佳解释是%2。</translation>
    </message>
    <message>
        <source>Measure guideway %1 with another instrument: separates %3 by %4 σ (sessions needed: %2).</source>
        <translation>用另一台仪器测量导轨 %1：可区分%3，相差 %4 σ（所需测量记录：%2 份）。</translation>
    </message>
    <message>
        <source>Measure guideway %1 with instrument %2: separates %4 by %5 σ (sessions needed: %3).</source>
        <translation>用仪器 %2 测量导轨 %1：可区分%4，相差 %5 σ（所需测量记录：%3 份）。</translation>
    </message>
    <message>
        <source>Measure another guideway with instrument %1: separates %3 by %4 σ (sessions needed: %2).</source>
        <translation>用仪器 %1 测量另一条导轨：可区分%3，相差 %4 σ（所需测量记录：%2 份）。</translation>
    </message>
    <message>
        <source>it has no date and is not used: enter the day of the measurement</source>
        <translation>没有日期，不参与：请录入测量日期</translation>
    </message>
    <message>
        <source>χ² = %1 with one degree of freedom, %2</source>
        <translation>χ² = %1，自由度 1，%2</translation>
    </message>
    <message>
        <source>the instrument&apos;s correction by its own calibration</source>
        <translation>仪器按自身的校准所作的改正</translation>
    </message>
    <message>
        <source>tilts that the compensator read</source>
        <translation>补偿器读出的倾斜量</translation>
    </message>
    <message>
        <source>the instrument&apos;s compensator, which was on</source>
        <translation>仪器的补偿器（已打开）</translation>
    </message>
    <message>
        <source>%1 is out of range: a tilt must be below 3600 arcseconds in size</source>
        <translation>%1 超出范围：倾斜量的大小必须小于 3600 角秒</translation>
    </message>
    <message>
        <source>%1 names no corrections: type one or more of inclination, standing_axis, collimation and tilting_axis, separated by blanks, or the word none</source>
        <translation>%1 不是改正项：请输入 inclination、standing_axis、collimation、tilting_axis 中的一个或多个，以空格分隔，或输入 none</translation>
    </message>
    <message>
        <source>With the opposite sign, the tilts would agree with the readings: look up the sign convention of the instrument&apos;s tilts.</source>
        <translation>若符号相反，倾斜量即与读数一致：请查明仪器的倾斜量以哪个方向为正。</translation>
    </message>
    <message>
        <source>The rows differ in what the instrument corrected by itself (%1), so none of these corrections is used as known.</source>
        <translation>各行中仪器自身所作的改正（%1）不一致，因此这些改正均不作为已知值采用。</translation>
    </message>
    <message>
        <source>Measure with the same corrections throughout, and state them with every reading.</source>
        <translation>请在整个测量中使用相同的改正，并在每个读数中注明。</translation>
    </message>
    <message>
        <source>The compensator&apos;s tilts are not used: the readings do not state whether the instrument has already corrected for them.</source>
        <translation>补偿器的倾斜量未采用：读数没有说明仪器是否已作倾斜改正。</translation>
    </message>
    <message>
        <source>According to the compensator, the vertical axis moved by %1″ from one position to another.</source>
        <translation>据补偿器，竖轴在两个轴位之间变动了 %1″。</translation>
    </message>
    <message>
        <source>Check the tripod; the uncertainty of the known tilt includes half of this movement.</source>
        <translation>请检查三脚架；倾斜已知值的不确定度中已计入这一变动的一半。</translation>
    </message>
    <message>
        <source>Calibrate the compensator&apos;s index. In face 2, tilts refer to the instrument&apos;s axes, which are turned by 180°.</source>
        <translation>请校准补偿器的指标差。盘右时，倾斜量以随仪器转过 180° 的轴系为准。</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完成。</translation>
    </message>
    <message>
        <source>The instrument does not accept this parameter.</source>
        <translation>仪器不接受该参数。</translation>
    </message>
    <message>
        <source>The instrument does not know this command.</source>
        <translation>仪器不认识这一命令。</translation>
    </message>
    <message>
        <source>The instrument is busy.</source>
        <translation>仪器正忙。</translation>
    </message>
    <message>
        <source>The instrument has no answer to this question.</source>
        <translation>仪器对这一询问没有应答。</translation>
    </message>
    <message>
        <source>The angles are not fully corrected: is the compensator within its range?</source>
        <translation>角度未完全改正：补偿器是否在其工作范围内？</translation>
    </message>
    <message>
        <source>The angles are good; there is no distance.</source>
        <translation>角度有效；没有距离。</translation>
    </message>
    <message>
        <source>The instrument could not read its circles: level it and try again.</source>
        <translation>仪器无法读取度盘：请整平后重试。</translation>
    </message>
    <message>
        <source>The instrument is busy measuring.</source>
        <translation>仪器正在测量。</translation>
    </message>
    <message>
        <source>The instrument cannot send: its buffer may be full.</source>
        <translation>仪器无法发送：其缓冲区可能已满。</translation>
    </message>
    <message>
        <source>The instrument reports an internal timeout.</source>
        <translation>仪器报告内部超时。</translation>
    </message>
    <message>
        <source>The instrument failed to answer.</source>
        <translation>仪器应答失败。</translation>
    </message>
    <message>
        <source>The instrument is switching off.</source>
        <translation>仪器正在关机。</translation>
    </message>
    <message>
        <source>The instrument answers with the return code %1.</source>
        <translation>仪器应答的返回码为 %1。</translation>
    </message>
    <message>
        <source>A reading is already being taken: no second one is requested.</source>
        <translation>已在读取一个读数：只请求一次。</translation>
    </message>
    <message>
        <source>This is no GeoCOM answer and was skipped: %1</source>
        <translation>这不是 GeoCOM 的应答，已略过：%1</translation>
    </message>
    <message>
        <source>An answer came late or twice and was dropped: %1</source>
        <translation>一个应答迟到或重复，已丢弃：%1</translation>
    </message>
    <message>
        <source>The request is sent again.</source>
        <translation>将再次询问。</translation>
    </message>
    <message>
        <source>An answer was corrupted in transmission and is requested again: %1</source>
        <translation>一个应答在传输中损坏，将再次询问：%1</translation>
    </message>
    <message>
        <source>The instrument failed to answer %1 times.</source>
        <translation>仪器 %1 次没有应答。</translation>
    </message>
    <message>
        <source>%1 No reading was taken; sight again.</source>
        <translation>%1 没有取得读数；请重新照准。</translation>
    </message>
    <message>
        <source>%1 Check that the instrument is on and set to GeoCOM at this baud rate, and that the port is right.</source>
        <translation>%1 请检查仪器是否已开机并设为 GeoCOM 及此波特率，端口是否正确。</translation>
    </message>
    <message>
        <source>a block needs both circles, words 21 and 22: put both into the recording mask of the instrument, and sight again</source>
        <translation>数据块须含两个度盘，即字 21 和 22：请将两者都设入仪器的记录格式，并重新照准</translation>
    </message>
    <message>
        <source>The instrument did not answer. No reading was taken; sight again, or record on the instrument. Check that the instrument is set to GSI at this baud rate, and that the port is right.</source>
        <translation>仪器没有应答。没有取得读数；请重新照准，或在仪器上记录。请检查仪器是否设为 GSI 及此波特率，端口是否正确。</translation>
    </message>
    <message>
        <source>The instrument reports an error: %1. Look at its display.</source>
        <translation>仪器报告错误：%1。请看其显示屏。</translation>
    </message>
    <message>
        <source>The instrument warns: %1. Look at its display.</source>
        <translation>仪器发出警告：%1。请看其显示屏。</translation>
    </message>
    <message>
        <source>This is no GSI block and was skipped: %1</source>
        <translation>这不是 GSI 数据块，已略过：%1</translation>
    </message>
    <message>
        <source>A block was not accepted: %1. The instrument sends it again, or reports an error.</source>
        <translation>一个数据块未被采用：%1。仪器会重发，或报告错误。</translation>
    </message>
    <message>
        <source>A block was received twice and used once: %1</source>
        <translation>一个数据块收到两次，只采用一次：%1</translation>
    </message>
    <message>
        <source>More than %1 characters came without an end of line; they were dropped (%2). Do baud rate, data bits and parity match the instrument?</source>
        <translation>收到超过 %1 个字符而没有行尾，已丢弃（%2）。波特率、数据位和校验是否与仪器一致？</translation>
    </message>
    <message>
        <source>Only part of a line came; it was dropped (%1). Is the cable plugged in?</source>
        <translation>只收到一行的一部分，已丢弃（%1）。电缆是否插好？</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>is empty: a calibration certificate states the day of the measurement, such as 2026-03-01</source>
        <translation>为空：校准证书须写明测量日期，如 2026-03-01</translation>
    </message>
    <message>
        <source>%1 is no date: write it in the form 2026-03-01</source>
        <translation>%1 不是日期：请写成 2026-03-01 的形式</translation>
    </message>
    <message>
        <source>the certificate would be issued on %1, before the measurement on %2: check both days</source>
        <translation>证书签发于 %1，早于测量日期 %2：请核对这两个日期</translation>
    </message>
    <message>
        <source>country</source>
        <translation>国家</translation>
    </message>
    <message>
        <source>%1 is no country: enter its two-letter code of ISO 3166-1, such as DE or CN</source>
        <translation>%1 不是国家代码：请写 ISO 3166-1 的两个字母，如 DE 或 CN</translation>
    </message>
    <message>
        <source>place of performance</source>
        <translation>测量地点类别</translation>
    </message>
    <message>
        <source>%1 is no place of performance: choose laboratory, customer, laboratoryBranch, customerBranch or other</source>
        <translation>%1 不是测量地点类别：请选 laboratory、customer、laboratoryBranch、customerBranch 或 other</translation>
    </message>
    <message>
        <source>Rotatable arc guideway, name not stated</source>
        <translation>可转动弧形导轨，名称未说明</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Nominal radius R0, at the temperature of the measurement</source>
        <translation>标称半径 R0（测量温度下）</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>适用范围</translation>
    </message>
    <message>
        <source>The results relate only to the item measured.</source>
        <translation>结果仅与被测对象有关。</translation>
    </message>
    <message>
        <source>Place of the measurement</source>
        <translation>测量地点</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>report number</source>
        <translation>报告编号</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>maker of the device</source>
        <translation>设备制造商</translation>
    </message>
    <message>
        <source>device serial number</source>
        <translation>设备序列号</translation>
    </message>
    <message>
        <source>laboratory</source>
        <translation>实验室</translation>
    </message>
    <message>
        <source>address of the laboratory</source>
        <translation>实验室地址</translation>
    </message>
    <message>
        <source>authorised by</source>
        <translation>批准人</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>客户</translation>
    </message>
    <message>
        <source>address of the customer</source>
        <translation>客户地址</translation>
    </message>
    <message>
        <source>No statement of conformity. %1</source>
        <translation>不作符合性声明。%1</translation>
    </message>
    <message>
        <source>Undecided: the value is within the tolerance, and the uncertainty reaches beyond it. %1</source>
        <translation>待定：值在允差之内，但其不确定度区间超出允差。%1</translation>
    </message>
    <message>
        <source>Undecided: the value is beyond the tolerance, and the uncertainty reaches into it. %1</source>
        <translation>待定：值在允差之外，但其不确定度区间与允差有重叠。%1</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>允差</translation>
    </message>
    <message>
        <source>Probability of conformance</source>
        <translation>合格概率</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>符合性声明</translation>
    </message>
    <message>
        <source>No statement of conformity: there is no intersection to judge.</source>
        <translation>不作符合性声明：没有可评判的相交度。</translation>
    </message>
    <message>
        <source>No statement of conformity: no tolerance is stated.</source>
        <translation>不作符合性声明：没有给出允差。</translation>
    </message>
    <message>
        <source>%1 Agreed by: %2</source>
        <translation>%1约定方：%2</translation>
    </message>
    <message>
        <source>The uncertainty comes from the scatter of the readings, the pointing zeros and the distance.</source>
        <translation>不确定度来自读数的离散、瞄准零位和距离。</translation>
    </message>
    <message>
        <source>Intersection Δd</source>
        <translation>相交度 Δd</translation>
    </message>
    <message>
        <source>Half the distance of the centres, |O1 − O2|/2</source>
        <translation>圆心距离的一半，|O1 − O2|/2</translation>
    </message>
    <message>
        <source>Distance of the arc&apos;s centre from the axis</source>
        <translation>圆心到回转轴的距离</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Δz, perpendicular to the plane of the arc</source>
        <translation>Δz，垂直于圆弧平面</translation>
    </message>
    <message>
        <source>d = √(Δd² + Δz²), whole distance from the axis</source>
        <translation>d = √(Δd² + Δz²)，到回转轴的整个距离</translation>
    </message>
    <message>
        <source>Arc in the position %1 of the axis</source>
        <translation>轴位 %1 的圆弧</translation>
    </message>
    <message>
        <source>Centre in the plane of the arc, relative to the theodolite&apos;s centre: x to the right, y up.</source>
        <translation>圆弧平面内的圆心，相对于经纬仪中心：x 向右，y 向上。</translation>
    </message>
    <message>
        <source>x of the centre %1</source>
        <translation>圆心 %1 的 x</translation>
    </message>
    <message>
        <source>y of the centre %1</source>
        <translation>圆心 %1 的 y</translation>
    </message>
    <message>
        <source>Radius of the arc</source>
        <translation>圆弧半径</translation>
    </message>
    <message>
        <source>Number of sightings</source>
        <translation>照准次数</translation>
    </message>
    <message>
        <source>Root mean square of the residuals</source>
        <translation>残差的均方根</translation>
    </message>
    <message>
        <source>Gap between model and readings</source>
        <translation>模型与读数的差距</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Intersection of a rotatable arc guideway</source>
        <translation>可转动弧形导轨的相交度</translation>
    </message>
    <message>
        <source>Rigorous least-squares fit of the arcs to theodolite readings</source>
        <translation>圆弧对经纬仪读数的严密最小二乘拟合</translation>
    </message>
    <message>
        <source>Directions and vertical angles to the slider in the positions 0° and 180° of the axis, adjusted together; Δd = (y(O1) − y(O2))/2, y up: positive if the arc&apos;s centre is higher at 0°.</source>
        <translation>轴位 0° 和 180° 时对滑块的水平方向与竖直角一并平差；Δd = (y(O1) − y(O2))/2，y 向上：圆心在 0° 时较高为正。</translation>
    </message>
    <message>
        <source>Diagnosis of the gap between model and readings</source>
        <translation>模型与读数差距的诊断</translation>
    </message>
    <message>
        <source>Calibration certificate of the instrument</source>
        <translation>仪器的校准证书</translation>
    </message>
    <message>
        <source>Standard uncertainty of a direction</source>
        <translation>水平方向的标准不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainty of a vertical angle</source>
        <translation>竖直角的标准不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainty of a pointing zero&apos;s direction</source>
        <translation>瞄准零位水平方向的标准不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainty of a pointing zero&apos;s vertical angle</source>
        <translation>瞄准零位竖直角的标准不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainty of a slider reading</source>
        <translation>滑块读数的标准不确定度</translation>
    </message>
    <message>
        <source>Theodolite, name not stated</source>
        <translation>经纬仪，名称未说明</translation>
    </message>
    <message>
        <source>Circles traceable: %1</source>
        <translation>度盘溯源：%1</translation>
    </message>
    <message>
        <source>Distance L from the theodolite to the plane of the arc</source>
        <translation>经纬仪到圆弧平面的距离 L</translation>
    </message>
    <message>
        <source>Measured: %1</source>
        <translation>测量方法：%1</translation>
    </message>
    <message>
        <source>Temperature of the device and of the air</source>
        <translation>设备和空气的温度</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>未确定</translation>
    </message>
    <message>
        <source>is far too long for a key or certificate: choose a PEM file</source>
        <translation>作为密钥或证书太长：请选择 PEM 文件</translation>
    </message>
    <message>
        <source>is protected by a passphrase: state the passphrase in the environment variable %1 or in a file (--sign-passphrase-file)</source>
        <translation>受口令保护：请在环境变量 %1 或文件（--sign-passphrase-file）中给出口令</translation>
    </message>
    <message>
        <source>cannot be opened with this passphrase: check the passphrase</source>
        <translation>用此口令打不开：请核对口令</translation>
    </message>
    <message>
        <source>holds no private key that can be read: choose a PEM file with one</source>
        <translation>其中没有可读的私钥：请选择含私钥的 PEM 文件</translation>
    </message>
    <message>
        <source>holds no certificate that can be read: choose a PEM file with one</source>
        <translation>其中没有可读的证书：请选择含证书的 PEM 文件</translation>
    </message>
    <message>
        <source>is not the certificate of the key %1: choose the two that belong together</source>
        <translation>不是密钥 %1 的证书：请选择相互匹配的两个文件</translation>
    </message>
    <message>
        <source>has expired (%1): sign with a valid certificate</source>
        <translation>已过期（%1）：请用有效的证书签名</translation>
    </message>
    <message>
        <source>is not valid before %1: check the clock, or sign with another certificate</source>
        <translation>在 %1 之前无效：请核对时钟，或换用其他证书</translation>
    </message>
    <message>
        <source>the signature cannot be made: %1</source>
        <translation>无法生成签名：%1</translation>
    </message>
    <message>
        <source>the file is too long to be signed</source>
        <translation>文件太长，无法签名</translation>
    </message>
    <message>
        <source>is missing, so this is no measurement protocol: choose a file with &quot;format&quot;: &quot;alidade-protocol&quot;</source>
        <translation>缺失，因此这不是测量方案文件：请选择含 &quot;format&quot;: &quot;alidade-protocol&quot; 的文件</translation>
    </message>
    <message>
        <source>choose a measurement protocol</source>
        <translation>请选择测量方案文件</translation>
    </message>
    <message>
        <source>%1 is no version of a measurement protocol: it must be %2</source>
        <translation>%1 不是测量方案的版本：必须是 %2</translation>
    </message>
    <message>
        <source>add the list of the positions of the axis, in their order</source>
        <translation>请按顺序加入轴位列表</translation>
    </message>
    <message>
        <source>is empty: add the positions of the axis, in their order</source>
        <translation>为空：请按顺序加入各轴位</translation>
    </message>
    <message>
        <source>make %1 sightings, and a protocol holds at most %2: leave out rounds or places</source>
        <translation>共有 %1 次照准，而一个方案最多 %2 次：请减少测回或位置</translation>
    </message>
    <message>
        <source>%1 occurs twice: each place needs a number of its own</source>
        <translation>%1 出现了两次：每个位置都有自己的编号</translation>
    </message>
    <message>
        <source>say which position of the axis: 0 or 180</source>
        <translation>请说明轴位：0 或 180</translation>
    </message>
    <message>
        <source>are missing: add the places of the slider, at least one</source>
        <translation>缺失：请加入滑块的位置，至少一个</translation>
    </message>
    <message>
        <source>is empty: add the rounds, at least one</source>
        <translation>为空：请加入测回，至少一个</translation>
    </message>
    <message>
        <source>names a face twice: a pointing zero is sighted once in each face</source>
        <translation>同一盘位出现两次：瞄准零位在每个盘位只照准一次</translation>
    </message>
    <message>
        <source>lacks face 1: before the readings the pointing zero is sighted in face 1, and optionally in face 2</source>
        <translation>缺少盘左（1）：读数前须在盘左照准瞄准零位，也可另加盘右</translation>
    </message>
    <message>
        <source>%1 is no direction through the places: write &quot;there&quot; or &quot;back&quot;</source>
        <translation>%1 不是经过各位置的方向：请写 &quot;there&quot;（往）或 &quot;back&quot;（返）</translation>
    </message>
    <message>
        <source>must be one face, both, or both for each of two places: [1], [1, 2], [2, 1], [1, 2, 2, 1]</source>
        <translation>应为一个盘位、双盘位，或两个位置各双盘位：[1]、[1, 2]、[2, 1]、[1, 2, 2, 1]</translation>
    </message>
    <message>
        <source>contains something other than a face: write 1 or 2, as in [1, 2]</source>
        <translation>含有不是盘位的内容：请写 1（盘左）或 2（盘右），如 [1, 2]</translation>
    </message>
    <message>
        <source>One more round</source>
        <translation>再测一个测回</translation>
    </message>
    <message>
        <source>Two more rounds</source>
        <translation>再测两个测回</translation>
    </message>
    <message>
        <source>Three more rounds</source>
        <translation>再测三个测回</translation>
    </message>
    <message>
        <source>%1 more rounds</source>
        <translation>再测 %1 个测回</translation>
    </message>
    <message>
        <source>The rest of the protocol brings U from %1 to %2 mm.</source>
        <translation>测完方案余下部分，U 将从 %1 mm 降至 %2 mm。</translation>
    </message>
    <message>
        <source>At its end, the protocol reaches U = %1 mm.</source>
        <translation>方案测完后 U = %1 mm。</translation>
    </message>
    <message>
        <source>%1 would bring U to %2 mm.</source>
        <translation>%1可使 U 达到 %2 mm。</translation>
    </message>
    <message>
        <source>Further rounds do not reduce %1 mm of U: that part is the same in each round.</source>
        <translation>更多测回不会减小 U 中的 %1 mm：这部分在每个测回中都相同。</translation>
    </message>
    <message>
        <source>More rounds are not enough: U always stays above %1 mm, and the verdict needs %2 mm.</source>
        <translation>增加测回无济于事：无论多少测回，U 都大于 %1 mm，而判定需要 %2 mm。</translation>
    </message>
    <message>
        <source>Even %1 more rounds leave U at %2 mm; the verdict needs %3 mm.</source>
        <translation>即使再测 %1 个测回，U 仍为 %2 mm；判定需要 %3 mm。</translation>
    </message>
    <message>
        <source>within the tolerance</source>
        <translation>在允差内</translation>
    </message>
    <message>
        <source>beyond the tolerance</source>
        <translation>超出允差</translation>
    </message>
    <message>
        <source>The readings are enough: U = %1 mm, and the verdict “%2” needs %3 mm.</source>
        <translation>读数已经足够：U = %1 mm，而判定“%2”需要 %3 mm。</translation>
    </message>
    <message>
        <source>The rest of the protocol brings U from %1 to %2 mm; the verdict needs %3 mm.</source>
        <translation>测完方案余下部分，U 将从 %1 mm 降至 %2 mm；判定需要 %3 mm。</translation>
    </message>
    <message>
        <source>One more round brings U from %1 to %2 mm; the verdict needs %3 mm.</source>
        <translation>再测一个测回，U 将从 %1 mm 降至 %2 mm；判定需要 %3 mm。</translation>
    </message>
    <message>
        <source>One round beyond the protocol brings U from %1 to %2 mm; the verdict needs %3 mm.</source>
        <translation>比方案多测一个测回，U 将从 %1 mm 降至 %2 mm；判定需要 %3 mm。</translation>
    </message>
    <message>
        <source>%1 bring U from %2 to %3 mm; the verdict needs %4 mm.</source>
        <translation>%1，U 将从 %2 mm 降至 %3 mm；判定需要 %4 mm。</translation>
    </message>
    <message>
        <source>%1 beyond the protocol bring U from %2 to %3 mm; the verdict needs %4 mm.</source>
        <translation>在方案之外%1，U 将从 %2 mm 降至 %3 mm；判定需要 %4 mm。</translation>
    </message>
    <message>
        <source>pointing zero after the readings</source>
        <translation>读数后瞄准零位</translation>
    </message>
    <message>
        <source>pointing zero after the readings, face 2</source>
        <translation>读数后瞄准零位，盘右</translation>
    </message>
    <message>
        <source>pointing zero</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>pointing zero, face 2</source>
        <translation>瞄准零位，盘右</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>已测</translation>
    </message>
    <message>
        <source>next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>待测</translation>
    </message>
    <message>
        <source>%1 of %2 sightings are taken.</source>
        <translation>%2 次照准中已完成 %1 次。</translation>
    </message>
    <message>
        <source>One was skipped.</source>
        <translation>有一次被跳过。</translation>
    </message>
    <message>
        <source>%1 were skipped.</source>
        <translation>有 %1 次被跳过。</translation>
    </message>
    <message>
        <source>One is excluded.</source>
        <translation>有一次已排除。</translation>
    </message>
    <message>
        <source>%1 are excluded.</source>
        <translation>有 %1 次已排除。</translation>
    </message>
    <message>
        <source>One was taken out of order.</source>
        <translation>有一次未按顺序测。</translation>
    </message>
    <message>
        <source>%1 were taken out of order.</source>
        <translation>有 %1 次未按顺序测。</translation>
    </message>
    <message>
        <source>One reading is not in the protocol.</source>
        <translation>有一个读数不属于方案。</translation>
    </message>
    <message>
        <source>%1 readings are not in the protocol.</source>
        <translation>有 %1 个读数不属于方案。</translation>
    </message>
    <message>
        <source>%1 again: the value typed can hardly be a reading.</source>
        <translation>%1 重测：所录入的不大可能是读得的值。</translation>
    </message>
    <message>
        <source>%1 again: its %2 reading disagrees with the others by %3.</source>
        <translation>%1 重测：其%2读数与其他读数不符，相差 %3。</translation>
    </message>
    <message>
        <source>%1 again in both faces: the difference of the faces on the %2 circle departs from the others by %3 (%4 σ).</source>
        <translation>%1 双盘位重测：%2度盘上两盘位之差与别处不同，相差 %3（%4 σ）。</translation>
    </message>
    <message>
        <source>%1 again, and in round %2: in that round the place lies %3 farther out (%4 σ).</source>
        <translation>%1 及测回 %2 重测：该测回中此位置偏外 %3（%4 σ）。</translation>
    </message>
    <message>
        <source>%1 again: its %2 reading differs from the earlier one by %3 (%4 σ). If the new reading differs too, the instrument has moved: sight the whole position again.</source>
        <translation>%1 重测：其%2读数与先前相差 %3（%4 σ）。若仍如此，则仪器已移动，该轴位须重新照准。</translation>
    </message>
    <message>
        <source>First repeat the sightings that look misread: they make U too large.</source>
        <translation>请先重测疑似误读的照准：它们使 U 偏大。</translation>
    </message>
    <message>
        <source>Once a pointing zero is read and the protocol has both positions, the rounds still needed are shown here.</source>
        <translation>有了瞄准零位、且方案含两个轴位后，此处即显示还需多少测回。</translation>
    </message>
    <message>
        <source>the diagnosis must name exactly what was simulated</source>
        <translation>诊断必须准确指出所模拟的内容</translation>
    </message>
    <message>
        <source>3 σ of the estimate: the readings hold noise, which is the same every time</source>
        <translation>估计值的 3 σ：读数含有噪声，每次都相同</translation>
    </message>
    <message>
        <source>1e-9 mm, a millionth of the smallest uncertainty: the fit stops within 1e-9 σ of the minimum, and rounding in double precision is a thousandth of that</source>
        <translation>1e-9 mm，最小不确定度的百万分之一：拟合在距最小值 1e-9 σ 以内停止，双精度舍入是其千分之一</translation>
    </message>
    <message>
        <source>1e-8: the fit stops within 1e-9 σ of the minimum, where σ and χ² are smooth</source>
        <translation>1e-8：拟合在距最小值 1e-9 σ 以内停止，σ 和 χ² 在该处是光滑的</translation>
    </message>
    <message>
        <source>SHA-256 of the whole file</source>
        <translation>整个文件的 SHA-256</translation>
    </message>
    <message>
        <source>the program does not run from where it was installed</source>
        <translation>程序不是从安装位置运行的</translation>
    </message>
    <message>
        <source>1e-10: probabilities and coverage factors are shown with five digits at most</source>
        <translation>1e-10：概率和包含因子最多显示五位数字</translation>
    </message>
    <message>
        <source>1e-15: a few rounding errors in double precision, 2e-16 each</source>
        <translation>1e-15：双精度下的若干次舍入误差，每次 2e-16</translation>
    </message>
    <message>
        <source>half of the last printed digit (JCGM 100:2008, table G.2)</source>
        <translation>末位印出数字的一半（JCGM 100:2008，表 G.2）</translation>
    </message>
    <message>
        <source>half of the last printed digit (Cui, Ren, Yuan, Liu)</source>
        <translation>末位印出数字的一半（Cui、Ren、Yuan、Liu）</translation>
    </message>
    <message>
        <source>every bit: a seed gives the same numbers on every machine</source>
        <translation>每一位：同一种子在任何机器上给出相同的数</translation>
    </message>
    <message>
        <source>every digit of every reading, compared by SHA-256: a seed gives the same session on every machine</source>
        <translation>每个读数的每一位，用 SHA-256 比较：同一种子在任何机器上给出相同的测量记录</translation>
    </message>
    <message>
        <source>1e-14: the quantile is worked out to 1e-16 and rounded some ten times</source>
        <translation>1e-14：分位数算到 1e-16，并舍入约十次</translation>
    </message>
    <message>
        <source>the check could not be made</source>
        <translation>无法进行检查</translation>
    </message>
    <message>
        <source>Sessions fitted at 60 digits by another implementation (stated σ, readings alone)</source>
        <translation>由另一实现以 60 位数字拟合的测量记录（给定 σ，仅读数）</translation>
    </message>
    <message>
        <source>The figures that the paper prints, by the published method</source>
        <translation>论文中印出的数值，按已发表的方法</translation>
    </message>
    <message>
        <source>Simulated sessions whose cause is known</source>
        <translation>原因已知的模拟测量记录</translation>
    </message>
    <message>
        <source>Coverage factors (t), tails of χ² and F, normal quantiles: reference values with 50 digits</source>
        <translation>包含因子（t）、χ² 与 F 的尾概率、正态分位数：参考值为 50 位数字</translation>
    </message>
    <message>
        <source>Conversion of typed angles: reference values with 50 digits</source>
        <translation>录入角度的换算：参考值为 50 位数字</translation>
    </message>
    <message>
        <source>Random numbers and a simulated session, by a second implementation</source>
        <translation>随机数和一份模拟测量记录，由另一实现给出</translation>
    </message>
    <message>
        <source>Files installed with the programs</source>
        <translation>与程序一同安装的文件</translation>
    </message>
    <message>
        <source>Contents built into the desktop program, and its fonts</source>
        <translation>桌面程序内置的内容及其字体</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>This installation does not pass: nothing could be checked.</source>
        <translation>本安装未通过：无法检查任何内容。</translation>
    </message>
    <message>
        <source>This installation does not pass: %1 of %2 lines failed. Do not use its results until this is explained.</source>
        <translation>本安装未通过：%2 行中有 %1 行未通过。在查明原因之前，不要使用其任何结果。</translation>
    </message>
    <message>
        <source>This installation passes: all %1 lines are within their tolerance.</source>
        <translation>本安装通过：全部 %1 行都在允许偏差之内。</translation>
    </message>
    <message>
        <source>a word of this page, in that language</source>
        <translation>本页中的一个词，以该语言表示</translation>
    </message>
    <message>
        <source>letters of reports and charts</source>
        <translation>报告和图表所用的字符</translation>
    </message>
    <message>
        <source>only a window or report in Chinese needs a Chinese font</source>
        <translation>只有中文窗口或中文报告需要中文字体</translation>
    </message>
    <message>
        <source>it is another user&apos;s link in a folder that everyone may write to: choose another name</source>
        <translation>它是他人在人人可写的文件夹中建立的链接：请另选名称</translation>
    </message>
    <message>
        <source>is accessible to other users: allow only its owner to read the key (chmod 600)</source>
        <translation>其他用户可以访问：请仅允许其所有者读取该私钥（chmod 600）</translation>
    </message>
    <message>
        <source>holds the same readings as %1: counted once</source>
        <translation>与 %1 的读数相同：只计一次</translation>
    </message>
    <message>
        <source>%1 holds the same readings as %2: counted once.</source>
        <translation>%1 与 %2 的读数相同：只计一次。</translation>
    </message>
    <message>
        <source>%1; its content was changed outside this program since: the sealed content cannot be rebuilt from the journal.</source>
        <translation>%1；其内容此后在本程序之外被更改：按更改日志无法还原到封存时的内容。</translation>
    </message>
    <message>
        <source>%1; the sealed content cannot be rebuilt from the journal and is not checked.</source>
        <translation>%1；无法由更改日志还原封存时的内容，未作检查。</translation>
    </message>
    <message>
        <source>%1: the file holds “%2”, but the journal records no change.</source>
        <translation>%1：文件中为“%2”，而更改日志中没有相应的更改。</translation>
    </message>
    <message>
        <source>%1: the journal says “%2”, and the file holds nothing.</source>
        <translation>%1：更改日志中为“%2”，而文件中为空。</translation>
    </message>
    <message>
        <source>%1: the journal says “%2”, and the file holds “%3”.</source>
        <translation>%1：更改日志中为“%2”，而文件中为“%3”。</translation>
    </message>
    <message>
        <source>Changed outside this program:</source>
        <translation>在本程序之外被更改：</translation>
    </message>
    <message>
        <source>Further places: %1.</source>
        <translation>其他位置：%1 处。</translation>
    </message>
    <message>
        <source>Entry %1 is earlier than the entry before it: the clock was set back, or one of the two times was changed.</source>
        <translation>第 %1 条早于其前一条：时钟曾被回拨，或其中一条的时间被更改。</translation>
    </message>
    <message>
        <source>is not a file of unfinished entries</source>
        <translation>不是未提交录入内容的文件</translation>
    </message>
    <message>
        <source>is a pipe or a device: choose a file</source>
        <translation>是管道或设备：请选择文件</translation>
    </message>
    <message>
        <source>%1 has digits of another script: type the digits 0 to 9</source>
        <translation>%1 含有其他文字的数字：请输入数字 0 到 9</translation>
    </message>
    <message>
        <source>The check sum of an answer does not match its text; the answer is requested again: %1</source>
        <translation>应答的校验和与其内容不符，重新询问：%1</translation>
    </message>
    <message>
        <source>The answers of the instrument were corrupted %1 times.</source>
        <translation>仪器的应答有 %1 次损坏。</translation>
    </message>
    <message>
        <source>The instrument says that an angle was keyed in, not measured.</source>
        <translation>仪器表明有一个角度是手工输入的，而非测得。</translation>
    </message>
    <message>
        <source>The instrument says that an angle is the result of one of its functions, not of a circle.</source>
        <translation>仪器表明有一个角度是其某项功能的结果，而非度盘读数。</translation>
    </message>
    <message>
        <source>%1 lacks degrees, minutes or seconds: enter 0 for the missing part</source>
        <translation>%1 缺少度、分、秒中的一项：请在缺少处填 0</translation>
    </message>
    <message>
        <source>%1 has a sign in the middle: put the sign before the degrees</source>
        <translation>%1 的正负号在中间：请将其放在度之前</translation>
    </message>
    <message>
        <source>%1 has %2 minutes: minutes go from 0 to %3</source>
        <translation>%1 的分为 %2：分应在 0 到 %3 之间</translation>
    </message>
    <message>
        <source>%1 has %2 seconds: seconds stay below %3</source>
        <translation>%1 的秒为 %2：秒应小于 %3</translation>
    </message>
    <message>
        <source>%1 can only be gon, as degrees end at 360: name the unit in the heading, such as Hz [gon], or choose gon as the unit (--unit gon)</source>
        <translation>%1 只能是 gon，因为度到 360 为止：请在列标题中写明单位，如 Hz [gon]，或选择 gon 作为单位（--unit gon）</translation>
    </message>
    <message>
        <source>the vertical readings are treated as elevations, because some are negative</source>
        <translation>竖直度盘读数中有负值，按高度角处理</translation>
    </message>
    <message>
        <source>the columns have other names from here on: put the rows that follow into a separate file</source>
        <translation>各列从此处起名称不同：请将其后各行另存为一个文件</translation>
    </message>
    <message>
        <source>angles with 60 seconds or minutes, read as the next minute or degree: %1, first in line %2</source>
        <translation>秒或分为 60 的角度，已进位为下一分或下一度：%1 个，首见于第 %2 行</translation>
    </message>
    <message>
        <source>content after the end of the file (^Z)</source>
        <translation>文件结束符（^Z）之后的内容</translation>
    </message>
    <message>
        <source>a further line of unknown format</source>
        <translation>另一行非本格式的文本</translation>
    </message>
    <message>
        <source>the text %1, no GSI word,</source>
        <translation>非 GSI 字的文本 %1</translation>
    </message>
    <message>
        <source>a further text that is no GSI word</source>
        <translation>另一段非 GSI 字的文本</translation>
    </message>
    <message>
        <source>is a file of the format %1, which this program does not read: export GSI, SDR, JobXML or a table (CSV) instead</source>
        <translation>是 %1 格式的文件，本程序不读取该格式：请改为导出 GSI、SDR、JobXML 或表格（CSV）</translation>
    </message>
    <message>
        <source>is a file of the format %1, which this program does not read: save its table as CSV and choose that file</source>
        <translation>是 %1 格式的文件，本程序不读取该格式：请将其中的表格另存为 CSV，再选择该文件</translation>
    </message>
    <message>
        <source>is a file of the format %1, which holds no readings of circles: choose the file of the instrument (GSI, SDR, M5, JobXML, LandXML) or a table (CSV)</source>
        <translation>是 %1 格式的文件，其中没有度盘读数：请选择仪器文件（GSI、SDR、M5、JobXML、LandXML）或表格（CSV）</translation>
    </message>
    <message>
        <source>its lines begin with For R4 or For R5</source>
        <translation>各行以 For R4 或 For R5 开头</translation>
    </message>
    <message>
        <source>its outermost element is JOBFile</source>
        <translation>其最外层元素为 JOBFile</translation>
    </message>
    <message>
        <source>its outermost element is LandXML</source>
        <translation>其最外层元素为 LandXML</translation>
    </message>
    <message>
        <source>is a file of the format %1: unpack it and choose the file in it</source>
        <translation>是 %1 格式的文件：请先解压，再选择其中的文件</translation>
    </message>
    <message>
        <source>has 8 characters, and a block that starts with * has 16: transfer the file again</source>
        <translation>只有 8 个字符，而以 * 开头的块为 16 个：请重新传输文件</translation>
    </message>
    <message>
        <source>has neither 8 nor 16 characters: transfer the file again, or correct or delete the line</source>
        <translation>既非 8 也非 16 个字符：请重新传输文件，或改正、删除该行</translation>
    </message>
    <message>
        <source>angles keyed in by hand, not measured: %1, first in line %2</source>
        <translation>手工输入、非测得的角度：%1 个，首见于第 %2 行</translation>
    </message>
    <message>
        <source>angles that a program of the instrument worked out, not measured: %1, first in line %2</source>
        <translation>由仪器程序算得、非测得的角度：%1 个，首见于第 %2 行</translation>
    </message>
    <message>
        <source>words with neither 8 nor 16 characters, used unchanged: %1, first in line %2</source>
        <translation>既非 8 也非 16 个字符、按原样采用的字：%1 个，首见于第 %2 行</translation>
    </message>
    <message>
        <source>is a second reading of its circle in one block: delete one of the two</source>
        <translation>是同一块中该度盘的第二个读数：请删除其中一个</translation>
    </message>
    <message>
        <source>the Trimble JobXML file holds no readings of circles in its field book: export the job with its observations, or export a table (CSV)</source>
        <translation>Trimble JobXML 文件的外业手簿中没有度盘读数：请连同观测值一起导出作业，或导出表格（CSV）</translation>
    </message>
    <message>
        <source>a deleted observation</source>
        <translation>已删除的观测</translation>
    </message>
    <message>
        <source>a mean of observations (MeanTurnedAngle)</source>
        <translation>多次观测的平均值（MeanTurnedAngle）</translation>
    </message>
    <message>
        <source>an observation that is no direct reading (%1)</source>
        <translation>不是直接读数的观测（%1）</translation>
    </message>
    <message>
        <source>a point without readings of circles</source>
        <translation>没有度盘读数的点</translation>
    </message>
    <message>
        <source>an observation without one of the circles</source>
        <translation>缺少一个度盘读数的观测</translation>
    </message>
    <message>
        <source>the LandXML file holds no raw observations with both circles: export the observations as they were read (RawObservation), or GSI or a table (CSV)</source>
        <translation>LandXML 文件中没有同时含两个度盘读数的原始观测：请按原始读数导出观测值（RawObservation），或导出 GSI 或表格（CSV）</translation>
    </message>
    <message>
        <source>%1 is no unit of angles of LandXML (radians, grads, decimal degrees, decimal dd.mm.ss): export the file in one of them</source>
        <translation>%1 不是 LandXML 的角度单位（radians、grads、decimal degrees、decimal dd.mm.ss）：请用其中一种单位导出文件</translation>
    </message>
    <message>
        <source>a reduced observation, not a circle reading</source>
        <translation>归算后的观测，不是度盘读数</translation>
    </message>
    <message>
        <source>%1 and %2 are not circle readings in radians, the default unit of a LandXML file: export the file with its unit of angles (angularUnit)</source>
        <translation>LandXML 文件未注明角度单位时以弧度为单位，而 %1 和 %2 按弧度不是度盘读数：请连同角度单位（angularUnit）一起导出文件</translation>
    </message>
    <message>
        <source>sightings of a point 0 when the station was set up (KN STAT), taken as the pointing zero: %1, first in line %2</source>
        <translation>设站（KN STAT）时对点 0 的照准，已作为瞄准零位：%1 次，首见于第 %2 行</translation>
    </message>
    <message>
        <source>degrees, minutes and any seconds are in separate columns</source>
        <translation>度、分以及可能有的秒各占一列</translation>
    </message>
    <message>
        <source>the collimation of the instrument (04)</source>
        <translation>仪器照准差（04）</translation>
    </message>
    <message>
        <source>a reduced observation (11)</source>
        <translation>归算后的观测值（11）</translation>
    </message>
    <message>
        <source>a record of a set (12)</source>
        <translation>测回记录（12）</translation>
    </message>
    <message>
        <source>is a corrected mean (09MC), and the file holds nothing else: send the observations raw (09F1, 09F2)</source>
        <translation>是改正后的平均值（09MC），文件中别无其他观测：请发送原始观测值（09F1、09F2）</translation>
    </message>
    <message>
        <source>a deleted record</source>
        <translation>已删除的记录</translation>
    </message>
    <message>
        <source>a record of the unknown type %1</source>
        <translation>未知类型 %1 的记录</translation>
    </message>
    <message>
        <source>the columns hold the horizontal circle in both faces and the vertical in one: name the columns of both faces, such as V I and V II</source>
        <translation>水平度盘有盘左和盘右两列，竖直度盘只有一列：请为两个盘位的列命名，如 V I 和 V II</translation>
    </message>
    <message>
        <source>the columns hold the vertical circle in both faces and the horizontal in one: name the columns of both faces, such as Hz I and Hz II</source>
        <translation>竖直度盘有盘左和盘右两列，水平度盘只有一列：请为两个盘位的列命名，如 Hz I 和 Hz II</translation>
    </message>
    <message>
        <source>%1 holds a part of an angle whose degrees or minutes have no column: name their columns, such as Hz deg, Hz min, Hz sec</source>
        <translation>%1 是角度的一部分，但没有其度或分的列：请为这些列命名，如 Hz deg、Hz min、Hz sec</translation>
    </message>
    <message>
        <source>%1 holds whole degrees and %2 may hold their minutes or seconds: name the columns, such as Hz deg, Hz min, Hz sec, or choose what each holds</source>
        <translation>%1 只有整度，而 %2 可能是其分或秒：请为这些列命名，如 Hz deg、Hz min、Hz sec，或选定各列的内容</translation>
    </message>
    <message>
        <source>%1 names the unit grad, which may be degrees or gon: name it deg or gon, or choose the unit (--unit deg, --unit gon)</source>
        <translation>%1 的单位写作 grad，可能是度，也可能是 gon：请写作 deg 或 gon，或选定单位（--unit deg、--unit gon）</translation>
    </message>
    <message>
        <source>minutes or seconds of 60 carry to the next degree or minute: %1 in all, the first in line %2</source>
        <translation>分或秒为 60 的进为下一度或下一分：共 %1 处，首处在第 %2 行</translation>
    </message>
    <message>
        <source>a full circle is taken as the zero of the circle: %1 in all, the first in line %2</source>
        <translation>整圆读数作为度盘的 0：共 %1 处，首处在第 %2 行</translation>
    </message>
    <message>
        <source>texts beyond the last named column are not used: %1 in all, the first in line %2</source>
        <translation>最后一个命名列之后的文字不使用：共 %1 处，首处在第 %2 行</translation>
    </message>
    <message>
        <source>looks like text in %1, but is not: save it as UTF-8 text</source>
        <translation>看似 %1 编码的文本，实则不是：请另存为 UTF-8 文本</translation>
    </message>
    <message>
        <source>is text in %1, which cannot be read on this computer: save it as UTF-8 text</source>
        <translation>是 %1 编码的文本，本机无法读取：请另存为 UTF-8 文本</translation>
    </message>
    <message>
        <source>rows of means or sums are not used: %1</source>
        <translation>平均值或合计的行不使用：%1</translation>
    </message>
    <message>
        <source>rows that name the columns again are skipped: %1</source>
        <translation>重复列标题的行已略过：%1</translation>
    </message>
    <message>
        <source>rows without a reading of a circle are not used: %1</source>
        <translation>没有度盘读数的行不使用：%1</translation>
    </message>
    <message>
        <source>has more than %1 elements and attributes: export the job in parts</source>
        <translation>元素和属性超过 %1 个：请分部分导出</translation>
    </message>
    <message>
        <source>the elements of the XML file are broken off or do not close: export it again</source>
        <translation>XML 文件的元素中断或未闭合：请重新导出</translation>
    </message>
    <message>
        <source>%1 is no reading of a circle in the unit of the file: export the file again, or delete the observation</source>
        <translation>按文件的单位，%1 不是度盘读数：请重新导出文件，或删除该观测</translation>
    </message>
    <message>
        <source>holds no readings of a circle: choose another file</source>
        <translation>不含度盘读数：请选择其他文件</translation>
    </message>
    <message>
        <source>files with both circles and files with one of them cannot be checked together: check them one after the other</source>
        <translation>同时有两个度盘的文件与只有一个度盘的文件不能一起检查：请逐个检查</translation>
    </message>
    <message>
        <source>has neither a vertical reading nor a face: state the face of each row, 1 or 2</source>
        <translation>既没有竖直读数，也没有盘位：请注明每行的盘位，1（盘左）或 2（盘右）</translation>
    </message>
    <message>
        <source>Only directions were read: the collimation applies to targets near the horizon; index and zenith angles are not evaluated.</source>
        <translation>只有方向读数：照准差适用于水平线附近的目标；指标差和天顶距不作评定。</translation>
    </message>
    <message>
        <source>Only zenith angles were read: collimation and directions are not evaluated.</source>
        <translation>只有天顶距读数：照准差和方向不作评定。</translation>
    </message>
    <message>
        <source>With these targets, a tilt of the trunnion axis is indistinguishable from an offset of the line of sight: the result states the one whose size is more usual.</source>
        <translation>这些目标无法区分横轴误差与视线偏离竖轴：结果给出其中大小更常见的一个。</translation>
    </message>
    <message>
        <source>Sight near and far targets at the same elevation as well.</source>
        <translation>请另外照准同一高度角上的近目标和远目标。</translation>
    </message>
    <message>
        <source>The collimation differs between targets by more than its scatter (%1): tilt of the trunnion axis, distance, or the way a target is sighted. Its u is taken from the differences between the targets.</source>
        <translation>照准差在目标之间的差异大于其离散（%1）：由横轴误差、距离或照准目标的方式引起。其 u 由目标之间的差异得出。</translation>
    </message>
    <message>
        <source>%1: the faces of target %2 differ by more than 2°, which is no collimation or index: check the face and the target of these lines</source>
        <translation>%1：目标 %2 的盘左与盘右相差超过 2°，不可能是照准差或指标差：请检查这些行的盘位和目标</translation>
    </message>
    <message>
        <source>%1: the horizontal circle counts in the opposite direction to that in %2 (target %3): set the same direction in all rounds, or check them one by one</source>
        <translation>%1：水平度盘的计数方向与%2相反（目标 %3）：请在所有测回中采用同一方向，或逐一检查</translation>
    </message>
    <message>
        <source>%1: target %2 is %3 from where it was sighted in %4: correct the reading; or name the stations if the instrument was moved, or the targets if they are different ones</source>
        <translation>%1：目标 %2 与其在%4中照准的位置相差 %3：请改正读数；若仪器移动过，请注明测站；若是不同的目标，请分别命名</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>%1: the %2 of target %3 departs by %4 from its median over the rounds: a reading is wrong, or the circle or the tripod moved within the round; correct these lines or leave the round out</source>
        <translation>%1：目标 %3 的%2与其各测回的中位数相差 %4：读数有误，或度盘、三脚架在测回内移动过；请改正这些行或去掉该测回</translation>
    </message>
    <message>
        <source>s of a direction</source>
        <translation>方向的 s</translation>
    </message>
    <message>
        <source>s of a zenith angle</source>
        <translation>天顶距的 s</translation>
    </message>
    <message>
        <source>tilt of the trunnion axis</source>
        <translation>横轴误差</translation>
    </message>
    <message>
        <source>offset of the line of sight</source>
        <translation>视线偏距</translation>
    </message>
    <message>
        <source>lines %1 to %2: %3 would be %4, which no theodolite has: these are not rounds in two faces to fixed targets</source>
        <translation>第 %1 行至第 %2 行：%3将为 %4，没有经纬仪会如此：这些不是对固定目标的双盘位测回</translation>
    </message>
    <message>
        <source>lines %1 and %2</source>
        <translation>第 %1 行和第 %2 行</translation>
    </message>
    <message>
        <source>Rounds from %1 on show other targets than those before: they are evaluated as another station.</source>
        <translation>从%1起的测回观测的目标与此前不同：按另一测站评定。</translation>
    </message>
    <message>
        <source>Target %1 (%2) is %3° from where it was sighted in an earlier round (%4): these rounds are evaluated as another station.</source>
        <translation>目标 %1（%2）与其在先前测回（%4）中照准的位置相差 %3°：这些测回按另一测站评定。</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be above -10 and below 10 mm</source>
        <translation>%1 超出范围：必须大于 -10 且小于 10 mm</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be 0 or more and below 10 mm</source>
        <translation>%1 超出范围：必须不小于 0 且小于 10 mm</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be above -1 and below 1</source>
        <translation>%1 超出范围：必须大于 -1 且小于 1</translation>
    </message>
    <message>
        <source>Intersection Δd, measured</source>
        <translation>相交度 Δd，实测</translation>
    </message>
    <message>
        <source>Includes every catalogued effect, limited by these readings or by its plausible size.</source>
        <translation>包含目录中的每个效应，其大小受这些读数或其合理大小限定。</translation>
    </message>
    <message>
        <source>not determined by these readings</source>
        <translation>这些读数不能确定</translation>
    </message>
    <message>
        <source>no diagnosis was made</source>
        <translation>未作诊断</translation>
    </message>
    <message>
        <source>Intersection Δd, fit only</source>
        <translation>相交度 Δd，仅拟合</translation>
    </message>
    <message>
        <source>radius on the way back</source>
        <translation>返测时的半径</translation>
    </message>
    <message>
        <source>horizontal readings along their circle</source>
        <translation>水平读数随度盘位置的变化</translation>
    </message>
    <message>
        <source>vertical readings along their circle</source>
        <translation>竖直读数随度盘位置的变化</translation>
    </message>
    <message>
        <source>horizontal readings on the way back</source>
        <translation>返测时的水平读数</translation>
    </message>
    <message>
        <source>vertical readings on the way back</source>
        <translation>返测时的竖直读数</translation>
    </message>
    <message>
        <source>vertical graduation</source>
        <translation>竖直度盘分度误差</translation>
    </message>
    <message>
        <source>the vertical circle&apos;s graduation error has two periods per turn</source>
        <translation>竖直度盘分度误差每周变化两次（二次谐波）</translation>
    </message>
    <message>
        <source>observe in both faces, and have the circle calibrated</source>
        <translation>双盘位观测，并校准度盘</translation>
    </message>
    <message>
        <source>vertical refraction</source>
        <translation>竖直折光</translation>
    </message>
    <message>
        <source>layers of warm air bend the lines of sight, in proportion to the square of the elevation (size at 10°)</source>
        <translation>暖空气层使视线弯曲，弯曲量与高度角的平方成正比（大小指高度角 10° 处）</translation>
    </message>
    <message>
        <source>keep sources of heat away, and stir the air</source>
        <translation>远离热源，并使空气流通</translation>
    </message>
    <message>
        <source>bend</source>
        <extracomment>how far a line of sight is bent</extracomment>
        <translation>弯曲量</translation>
    </message>
    <message>
        <source>plane skew</source>
        <translation>平面歪斜</translation>
    </message>
    <message>
        <source>the arc plane is askew to the rotation axis, and turns over with the guideway</source>
        <translation>圆弧平面相对回转轴歪斜，且随导轨一同翻转</translation>
    </message>
    <message>
        <source>read the slider, and square the guideway to its axis</source>
        <translation>读取滑块，并将导轨调至与其轴正交</translation>
    </message>
    <message>
        <source>skew</source>
        <extracomment>how far something is askew</extracomment>
        <translation>歪斜量</translation>
    </message>
    <message>
        <source>arm sag</source>
        <translation>滑块臂下垂</translation>
    </message>
    <message>
        <source>the slider&apos;s arm bends under its weight, most where it is horizontal</source>
        <translation>滑块臂因自重弯曲，越接近水平弯曲越大</translation>
    </message>
    <message>
        <source>read the slider, and stiffen its arm</source>
        <translation>读取滑块，并加固滑块臂</translation>
    </message>
    <message>
        <source>%1 is no plane of the arc: choose vertical or square</source>
        <translation>%1 不是圆弧平面的取值：请选择 vertical 或 square</translation>
    </message>
    <message>
        <source>%1 is no target of a pointing zero: choose mark, normal or unknown</source>
        <translation>%1 不是瞄准零位所照准的对象：请选择 mark、normal 或 unknown</translation>
    </message>
    <message>
        <source>%1 is %2° away from the horizon, too steep for a sighting of the arc: check the degrees and the face</source>
        <translation>%1 偏离水平方向 %2°，对照准圆弧而言过陡：请检查度数和盘位</translation>
    </message>
    <message>
        <source>%1 (%2 periods in a turn)</source>
        <translation>%1（每周 %2 个周期）</translation>
    </message>
    <message>
        <source>%1, instrument %2</source>
        <translation>%1，仪器 %2</translation>
    </message>
    <message>
        <source>%1, guideway %2</source>
        <translation>%1，导轨 %2</translation>
    </message>
    <message>
        <source>The sessions (%1) share a gap that no effect of the catalogue explains.</source>
        <translation>这些测量记录（共 %1 份）有共同的差距，目录中没有效应可以解释。</translation>
    </message>
    <message>
        <source>In most sessions (%1), each alone, no effect of the catalogue explains the gap.</source>
        <translation>大多数测量记录（共 %1 份）各自的差距，目录中没有效应可以解释。</translation>
    </message>
    <message>
        <source>%1 It follows a pattern: %2.</source>
        <translation>%1该差距遵循规律：%2。</translation>
    </message>
    <message>
        <source>%1 In addition the sessions share %2.</source>
        <translation>%1此外它们共有%2。</translation>
    </message>
    <message>
        <source>Probability of an uncatalogued effect: %1.</source>
        <translation>目录之外效应的概率：%1。</translation>
    </message>
    <message>
        <source>The pointing zeros differ by %1 horizontally and %2 vertically, more than two sightings of one mark would.</source>
        <translation>各瞄准零位水平相差 %1、竖直相差 %2，超过对同一标志两次照准的差异。</translation>
    </message>
    <message>
        <source>State under “Zeros sight” the target of the zeros: a mark; the guideway&apos;s own normal, set again in each position; or unknown.</source>
        <translation>请在“零位照准”中说明照准的是什么：标志、在每个轴位重新设定的导轨自身法线，或未知。</translation>
    </message>
    <message>
        <source>Δd, measured, is averaged over every explanation that the readings do not exclude, with every catalogued effect as large as readings and its plausible or known size allow.</source>
        <translation>实测 Δd 是读数未能排除的所有解释的平均，目录中每个效应的大小以读数及其合理大小或已知值为限。</translation>
    </message>
    <message>
        <source>%1 point %2</source>
        <translation>%1 测点 %2</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>待定</translation>
    </message>
    <message>
        <source>one of %1 others</source>
        <translation>其余 %1 行之一</translation>
    </message>
    <message>
        <source>%1 without %2</source>
        <translation>%1（去掉 %2）</translation>
    </message>
    <message>
        <source>between the pointing zero and the first sighting at %1</source>
        <translation>在 %1 的瞄准零位与首次照准之间</translation>
    </message>
    <message>
        <source>during the readings at %1</source>
        <translation>在 %1 的读数期间</translation>
    </message>
    <message>
        <source>There are more causes than these readings can separate. With every effect of the catalogue at a plausible size, %1.</source>
        <extracomment>&quot;the residuals shrink from 12.0″ to 2.0″&quot;</extracomment>
        <translation>原因多于这些读数所能区分的。把目录中的所有效应按合理大小计入后，%1。</translation>
    </message>
    <message>
        <source>%1 Only this is certain: %2.</source>
        <translation>%1可以确定的只有：%2。</translation>
    </message>
    <message>
        <source>Δd, fit only, and Δd, measured, are on different sides of the tolerance: look at the gap before you sight more.</source>
        <translation>仅拟合 Δd 与实测 Δd 分处允差两侧：继续照准前请先查看差距。</translation>
    </message>
    <message>
        <source>All readings of the vertical circle are multiples of %1: rounding alone scatters them by %2 (1σ), more than the stated %3.</source>
        <translation>竖直度盘的所有读数都是 %1 的整数倍：仅修约就使其离散 %2（1σ），超过给定的 %3。</translation>
    </message>
    <message>
        <source>All readings of the horizontal circle are multiples of %1: rounding alone scatters them by %2 (1σ), more than the stated %3.</source>
        <translation>水平度盘的所有读数都是 %1 的整数倍：仅修约就使其离散 %2（1σ），超过给定的 %3。</translation>
    </message>
    <message>
        <source>Enter the readings as finely as the instrument gives them, or state a σ of at least %1.</source>
        <translation>请按仪器给出的分辨力输入读数，或给定不小于 %1 的 σ。</translation>
    </message>
    <message>
        <source>Δd = %2, all effects considered; %1 from the fit only. Neither interval is wholly within or wholly outside %3.</source>
        <translation>Δd = %2，计入全部效应；仅拟合为 %1。两个区间都既不完全在%3之内，也不完全在其外。</translation>
    </message>
    <message>
        <source>Δd = %2, all effects considered; %1 from the fit only. Both intervals are %3.</source>
        <translation>Δd = %2，计入全部效应；仅拟合为 %1。两个区间都%3。</translation>
    </message>
    <message>
        <source>Most of U comes from %1 at its plausible size: with %2, U would be about %3 mm.</source>
        <translation>U 主要来自按合理大小计的%1：加上%2，U 约为 %3 mm。</translation>
    </message>
    <message>
        <source>Most of U comes from %1 at its plausible size: take readings that show it.</source>
        <translation>U 主要来自按合理大小计的%1：请测量能显示它的量。</translation>
    </message>
    <message>
        <source>Δd = %1 from the fit only, %2. With the causes of the diagnosis, these readings do not determine Δd.</source>
        <translation>仅拟合 Δd = %1，%2。计入诊断所得原因后，这些读数不能确定 Δd。</translation>
    </message>
    <message>
        <source>Δd = %1, all effects considered, is %2; Δd from the fit only, %3, is %4. %5</source>
        <translation>Δd = %1，计入全部效应，%2；仅拟合 Δd = %3，%4。%5</translation>
    </message>
    <message>
        <source>The arc&apos;s centre is %1 from the axis, all effects considered: %2 in the plane of the arc (Δd), %3 perpendicular to it (Δz). The interval is %4.</source>
        <translation>计入全部效应，圆心到回转轴的距离为 %1：圆弧平面内 %2（Δd），垂直于该平面 %3（Δz）。该区间%4。</translation>
    </message>
    <message>
        <source>With a probability of %1 the gap is real and no catalogued effect explains it.</source>
        <translation>差距确实存在且目录中没有效应可以解释的概率：%1。</translation>
    </message>
    <message>
        <source>Misclosures without a catalogued cause add ± %1 mm (1σ); verdict and probability include this amount.</source>
        <translation>没有目录内原因的闭合差另增加 ± %1 mm（1σ）；判定与概率均已计入这一数值。</translation>
    </message>
    <message>
        <source>The verdict is open. %1</source>
        <translation>判定待定。%1</translation>
    </message>
    <message>
        <source>%1 Probability of conformity: %2.</source>
        <translation>%1合格概率：%2。</translation>
    </message>
    <message>
        <source>Δd = %1 from the fit only; the interval is within %2.</source>
        <translation>仅拟合 Δd = %1；该区间在%2之内。</translation>
    </message>
    <message>
        <source>Δd = %1 from the fit only; the interval is outside %2.</source>
        <translation>仅拟合 Δd = %1；该区间在%2之外。</translation>
    </message>
    <message>
        <source>Δd = %1 from the fit only; the interval is neither wholly within nor wholly outside %2.</source>
        <translation>仅拟合 Δd = %1；该区间既不完全在%2之内，也不完全在其外。</translation>
    </message>
    <message>
        <source>Distance d of the arc&apos;s centre from the axis: pass if d + U ≤ %1 mm, measured, and |Δd| + U ≤ %1 mm, fit only; fail if d − U &gt; %1 mm. Guard band w = U at a coverage of %2 %.</source>
        <translation>圆心到回转轴的距离 d：实测 d + U ≤ %1 mm 且仅拟合 |Δd| + U ≤ %1 mm 时合格；d − U &gt; %1 mm 时不合格。保护带 w = U，包含概率 %2 %。</translation>
    </message>
    <message>
        <source>Intersection Δd, both measured and fit only: pass if |Δd| + U ≤ %1 mm, fail if |Δd| − U &gt; %1 mm. Guard band w = U at a coverage of %2 %.</source>
        <translation>相交度 Δd（实测与仅拟合均须满足）：|Δd| + U ≤ %1 mm 时合格，|Δd| − U &gt; %1 mm 时不合格。保护带 w = U，包含概率 %2 %。</translation>
    </message>
    <message>
        <source>Δd, measured</source>
        <translation>Δd，实测</translation>
    </message>
    <message>
        <source>Δd, fit only</source>
        <translation>Δd，仅拟合</translation>
    </message>
    <message>
        <source>U of Δd, fit only, is %1 mm now and %2 mm at the end of the protocol.</source>
        <translation>仅拟合 Δd 的 U 目前为 %1 mm，测量方案完成时为 %2 mm。</translation>
    </message>
    <message>
        <source>U of Δd, fit only, is %1 mm at the end of the protocol.</source>
        <translation>测量方案完成时，仅拟合 Δd 的 U 为 %1 mm。</translation>
    </message>
    <message>
        <source>The base columns leave no degree of freedom in the %1 residuals: leave out some of the columns.</source>
        <translation>base 列使 %1 个残差没有剩余自由度：请去掉一些列。</translation>
    </message>
    <message>
        <source>The table has %1 rows of residuals: forms need at least %2.</source>
        <translation>表中有 %1 行残差：求形式至少需要 %2 行。</translation>
    </message>
    <message>
        <source>Line %1: the column %2 occurs twice. Remove one of them.</source>
        <translation>第 %1 行：列 %2 出现两次。请删除其中一列。</translation>
    </message>
    <message>
        <source>The table has %1 base columns: at most %2 are read.</source>
        <translation>表中有 %1 个 base 列：最多读取 %2 个。</translation>
    </message>
    <message>
        <source>Line %1: there is no column %2. The first row names the columns: residual_arcsec, sigma_arcsec, circle, azimuth_deg, elevation_deg.</source>
        <translation>第 %1 行：缺少列 %2。首行给出列名：residual_arcsec、sigma_arcsec、circle、azimuth_deg、elevation_deg。</translation>
    </message>
    <message>
        <source>The table has more than %1 rows: leave some of them out.</source>
        <translation>表超过 %1 行：请去掉一部分。</translation>
    </message>
    <message>
        <source>Line %1: the circle %2 is unknown. Enter horizontal or vertical.</source>
        <translation>第 %1 行：度盘 %2 未知。请填写 horizontal 或 vertical。</translation>
    </message>
    <message>
        <source>Line %1: %2 is %3, which is no number. Correct it or leave the row out.</source>
        <translation>第 %1 行：%2 为 %3，不是数。请更正或去掉该行。</translation>
    </message>
    <message>
        <source>Line %1: %2 is %3, outside %4. Correct it or leave the row out.</source>
        <translation>第 %1 行：%2 为 %3，超出 %4。请更正或去掉该行。</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>place along the arc</source>
        <translation>沿弧位置</translation>
    </message>
    <message>
        <source>guideway across its plane</source>
        <translation>导轨偏离其平面</translation>
    </message>
    <message>
        <source>target in x</source>
        <translation>目标 x 方向</translation>
    </message>
    <message>
        <source>target in y</source>
        <translation>目标 y 方向</translation>
    </message>
    <message>
        <source>target in z</source>
        <translation>目标 z 方向</translation>
    </message>
    <message>
        <source>horizontal readings</source>
        <translation>水平读数</translation>
    </message>
    <message>
        <source>vertical readings</source>
        <translation>竖直读数</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>定向</translation>
    </message>
    <message>
        <source>(1 there, −1 back)</source>
        <translation>（往测 1，返测 −1）</translation>
    </message>
    <message>
        <source>(1 in face 1, −1 in face 2)</source>
        <translation>（盘左 1，盘右 −1）</translation>
    </message>
    <message>
        <source>(1 at 0°, −1 at 180°)</source>
        <translation>（0° 位 1，180° 位 −1）</translation>
    </message>
    <message>
        <source>%1, turning with the guideway</source>
        <translation>%1，随导轨转动</translation>
    </message>
    <message>
        <source>%1, with the other sign in face 2</source>
        <translation>%1，盘右时反号</translation>
    </message>
    <message>
        <source>%1 with the other sign in face 2</source>
        <translation>%1（盘右时反号）</translation>
    </message>
    <message>
        <source>horizontal orientation%1, vertical orientation%2</source>
        <translation>水平定向%1，竖直定向%2</translation>
    </message>
    <message>
        <source>The form: %1 (probability %2).</source>
        <translation>形式：%1（概率 %2）。</translation>
    </message>
    <message>
        <source>These readings cannot distinguish the form from: %1.</source>
        <translation>这些读数无法将该形式与下列区分：%1。</translation>
    </message>
    <message>
        <source>a session without a title</source>
        <translation>无标题的测量记录</translation>
    </message>
    <message>
        <source>found in %1</source>
        <translation>见于 %1</translation>
    </message>
    <message>
        <source>found in %1 of %2</source>
        <translation>见于 %2 的 %1</translation>
    </message>
    <message>
        <source>In %1 of %2 evaluations at these readings, the formula has no finite value: 0 is used instead.</source>
        <translation>在这些读数处对公式的 %2 次求值中有 %1 次不是有限值：该处按 0 计。</translation>
    </message>
    <message>
        <source>This effect is undetectable here, as the fit absorbs it: its trace is %1 σ per %2.</source>
        <translation>此效应在此无法检出，因为拟合将其吸收：每 %2 的痕迹为 %1 σ。</translation>
    </message>
    <message>
        <source>This effect has nearly the same trace as %1 of the catalogue: these readings cannot distinguish the two.</source>
        <translation>此效应的痕迹与目录中的%1几乎相同：这些读数无法区分二者。</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>is missing, so this is no effect file: choose a file with &quot;format&quot;: &quot;alidade-effect&quot;</source>
        <translation>缺失，因此这不是效应文件：请选择含 &quot;format&quot;: &quot;alidade-effect&quot; 的文件</translation>
    </message>
    <message>
        <source>choose an effect file</source>
        <translation>请选择一个效应文件</translation>
    </message>
    <message>
        <source>%1 is no version of an effect file: it must be %2</source>
        <translation>%1 不是效应文件的版本：必须是 %2</translation>
    </message>
    <message>
        <source>is no plausible size: type a number above 0</source>
        <translation>不是合理大小：请输入大于 0 的数</translation>
    </message>
    <message>
        <source>is not the unit of %1, which is %2</source>
        <translation>不是 %1 的单位，其单位为 %2</translation>
    </message>
    <message>
        <source>must be up to 40 letters, digits, _ or -</source>
        <translation>必须是至多 40 个字母、数字、_ 或 -</translation>
    </message>
    <message>
        <source>%1 is no amplitude of the formula</source>
        <translation>%1 不是公式中的幅值</translation>
    </message>
    <message>
        <source>is used by another effect of the session: choose another one</source>
        <translation>已用于测量记录中的另一效应：请换一个</translation>
    </message>
    <message>
        <source>has too many amplitudes: a session&apos;s own effects may have at most %1 together</source>
        <translation>幅值过多：一份测量记录的自定义效应总共最多 %1 个</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <extracomment>the place in a formula, then a sentence on it</extracomment>
        <translation>第 %1 行第 %2 列：%3</translation>
    </message>
    <message>
        <source>The formula is too long: it may have at most %1 characters.</source>
        <translation>公式过长：最多 %1 个字符。</translation>
    </message>
    <message>
        <source>No line says what is displaced: add one such as radial = A*cos(2*s).</source>
        <translation>没有一行说明位移的对象：请添加一行，例如 radial = A*cos(2*s)。</translation>
    </message>
    <message>
        <source>%1 cannot be set: left of = must be the displaced quantity, such as radial, or a new name.</source>
        <translation>不能给 %1 赋值：等号左边应为被位移的量（例如 radial）或新名称。</translation>
    </message>
    <message>
        <source>This line sets %1 to a number: remove %2.</source>
        <translation>此行将 %1 设为一个数：请去掉 %2。</translation>
    </message>
    <message>
        <source>This is no finite number.</source>
        <translation>这不是有限的数。</translation>
    </message>
    <message>
        <source>The expression has no amplitude: multiply it by a letter such as A.</source>
        <translation>表达式没有幅值：请乘以一个字母，例如 A。</translation>
    </message>
    <message>
        <source>%1 is one amplitude too many: there may be %2.</source>
        <translation>%1 使幅值过多：最多 %2 个。</translation>
    </message>
    <message>
        <source>The line %2, which is of another kind, already uses %1: use another letter here.</source>
        <translation>%1 已属于另一类的行 %2：请在此处使用另一个字母。</translation>
    </message>
    <message>
        <source>The line must be a sum of terms, each with exactly one amplitude as a factor.</source>
        <translation>该行必须是各项之和，每项恰含一个幅值作为因子。</translation>
    </message>
    <message>
        <source>The line is not in proportion to %1: multiply by it, or set it to a number, such as %2 = 1.</source>
        <translation>该行与 %1 不成正比：请乘以它，或将其设为一个数，例如 %2 = 1。</translation>
    </message>
    <message>
        <source>The formula cannot be read: write it more simply.</source>
        <translation>无法读取公式：请写得更简单。</translation>
    </message>
    <message>
        <source>The expression ends where a number or a name is missing.</source>
        <translation>表达式在缺少数或名称处结束。</translation>
    </message>
    <message>
        <source>This parenthesis is not closed: add ) where it ends.</source>
        <translation>此括号未闭合：请在其结尾处添加 )。</translation>
    </message>
    <message>
        <source>The sign ° is allowed only after a number, such as 83°.</source>
        <translation>符号 ° 只能位于数之后，例如 83°。</translation>
    </message>
    <message>
        <source>The sign %1 has no meaning in a formula: take it out.</source>
        <translation>符号 %1 在公式中没有意义：请去掉。</translation>
    </message>
    <message>
        <source>An operator such as * is missing before %1.</source>
        <translation>%1 之前缺少运算符，例如 *。</translation>
    </message>
    <message>
        <source>This is no valid number: type one up to 10^15, with a point as decimal sign.</source>
        <translation>这不是有效的数：请输入不大于 10^15 的数，小数点用句点。</translation>
    </message>
    <message>
        <source>%1 is not a known function: use bump, step, hinge, exponential, sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, exp, ln, sqrt, abs, sign, min or max.</source>
        <translation>%1 不是可用的函数：请用 bump、step、hinge、exponential、sin、cos、tan、asin、acos、atan、atan2、sinh、cosh、tanh、exp、ln、sqrt、abs、sign、min 或 max。</translation>
    </message>
    <message>
        <source>The readings have no temperature of their own: take another variable, such as t, the elapsed share of the session.</source>
        <translation>读数没有各自的温度：请用另一个变量，例如 t（测量过程已过去的时间份额）。</translation>
    </message>
    <message>
        <source>%1 cannot be an amplitude, as it has another meaning: take a letter such as A.</source>
        <translation>%1 另有含义，不能作为幅值：请用一个字母，例如 A。</translation>
    </message>
    <message>
        <source>The name is too long: take one of at most %1 letters.</source>
        <translation>名称过长：最多 %1 个字母。</translation>
    </message>
    <message>
        <source>There are too many parentheses inside one another.</source>
        <translation>括号嵌套过多。</translation>
    </message>
    <message>
        <source>No parenthesis is open here: take ) out.</source>
        <translation>此处没有未闭合的括号：请去掉 )。</translation>
    </message>
    <message>
        <source>A number or a name is missing before ).</source>
        <translation>) 之前缺少数或名称。</translation>
    </message>
    <message>
        <source>%1 takes one argument: write %1(x).</source>
        <translation>%1 有一个自变量：请写 %1(x)。</translation>
    </message>
    <message>
        <source>%1 takes two arguments: write %1(x, y).</source>
        <translation>%1 有两个自变量：请写 %1(x, y)。</translation>
    </message>
    <message>
        <source>%1 takes three arguments: write %1(x, at, width).</source>
        <translation>%1 有三个自变量：请写 %1(x, at, width)。</translation>
    </message>
    <message>
        <source>A comma is allowed only between the arguments of a function. In numbers, type a decimal point.</source>
        <translation>逗号只能位于函数的自变量之间。数中的小数点请用句点。</translation>
    </message>
    <message>
        <source>A number or a name is missing before the comma.</source>
        <translation>逗号之前缺少数或名称。</translation>
    </message>
    <message>
        <source>A number or a name is missing before %1.</source>
        <translation>%1 之前缺少数或名称。</translation>
    </message>
    <message>
        <source>Put a negative exponent in parentheses, such as x^(-1).</source>
        <translation>负指数请加括号，例如 x^(-1)。</translation>
    </message>
    <message>
        <source>A line begins with what it displaces, such as radial = A*cos(2*s).</source>
        <translation>一行以位移的对象开头，例如 radial = A*cos(2*s)。</translation>
    </message>
    <message>
        <source>A line has only one =: begin a new line, or put a semicolon before it.</source>
        <translation>一行只能有一个 =：请另起一行，或在其前加分号。</translation>
    </message>
    <message>
        <source>a random walk</source>
        <translation>随机游走</translation>
    </message>
    <message>
        <source>a separate value for each place</source>
        <translation>每个位置一个数</translation>
    </message>
    <message>
        <source>The form displaces readings by more than their σ over the whole range of %1.</source>
        <translation>此形式使读数的偏移在 %1 的整个范围内均大于其 σ。</translation>
    </message>
    <message>
        <source>is one effect too many: a session may have at most %1</source>
        <translation>效应过多：一份测量记录最多 %1 个</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>其他 %1 项</translation>
    </message>
    <message>
        <source>Standard uncertainty of Δd, measured</source>
        <translation>实测 Δd 的标准不确定度</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>size from</source>
        <translation>大小来源</translation>
    </message>
    <message>
        <source>combined, u</source>
        <translation>合成，u</translation>
    </message>
    <message>
        <source>expanded, U</source>
        <translation>扩展，U</translation>
    </message>
    <message>
        <source>Δd, measured, includes every catalogued effect, limited by these readings or by its plausible size.</source>
        <translation>实测 Δd 包含目录中的每个效应，其大小受这些读数或其合理大小限定。</translation>
    </message>
    <message>
        <source>Standard uncertainty of Δd, fit only</source>
        <translation>仅拟合 Δd 的标准不确定度</translation>
    </message>
    <message>
        <source>many</source>
        <translation>很多</translation>
    </message>
    <message>
        <source>found in %1 sessions, first in %2</source>
        <translation>在 %1 份测量记录中发现，最早见于%2</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 份</translation>
    </message>
    <message>
        <source>Sessions of %1 show the same form, %2 (u %3): %4. The form can be kept as an effect.</source>
        <translation>%1的多份测量记录显示同一形式，%2（u %3）：%4。可将该形式存为效应。</translation>
    </message>
    <message>
        <source>The %1 failed: %2. Nothing typed is lost; save the session and go on. A description of the fault is in %3.</source>
        <translation>%1失败：%2。录入的内容没有丢失；请保存测量记录后继续。故障的描述在 %3。</translation>
    </message>
    <message>
        <source>The %1 failed: %2. Nothing typed is lost; save the session and go on. A description of the fault could not be written to %3.</source>
        <translation>%1失败：%2。录入的内容没有丢失；请保存测量记录后继续。故障的描述无法写入 %3。</translation>
    </message>
    <message>
        <source>would show %1 at %2 σ or more</source>
        <translation>能以 %2 σ 或更高的程度显示%1</translation>
    </message>
    <message>
        <source>separates %1 by %2 σ or more</source>
        <translation>能以不小于 %2 σ 的差异区分%1</translation>
    </message>
    <message>
        <source>separates any two of %1 by %2 σ or more</source>
        <translation>能以不小于 %2 σ 的差异两两区分%1</translation>
    </message>
    <message>
        <source>%1; probability that only one cause remains: %2</source>
        <translation>%1；只剩一个原因的概率为 %2</translation>
    </message>
    <message>
        <source>What to measure next</source>
        <translation>接下来测量什么</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>rows, about</source>
        <translation>约需行数</translation>
    </message>
    <message>
        <source>What it shows</source>
        <translation>能说明什么</translation>
    </message>
    <message>
        <source>Further readings of the usual kinds would add no information.</source>
        <translation>常见种类的进一步读数不会提供更多信息。</translation>
    </message>
    <message>
        <source>closes %1: %2 σ → %3 σ</source>
        <translation>使 %1 闭合：%2 σ → %3 σ</translation>
    </message>
    <message>
        <source>residuals %1″ → %2″</source>
        <translation>残差 %1″ → %2″</translation>
    </message>
    <message>
        <source>reduced χ² %1 → %2</source>
        <translation>约化 χ² %1 → %2</translation>
    </message>
    <message>
        <source>order</source>
        <translation>阶数</translation>
    </message>
    <message>
        <source>cycles</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>at</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>before %1, row %2</source>
        <extracomment>a position and a row of it: &quot;before 0°, row 35&quot;</extracomment>
        <translation>在 %1 第 %2 行之前</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <extracomment>what a form is carried by, and its function: &quot;Form: radius, cos 7s&quot;</extracomment>
        <translation>形式：%1</translation>
    </message>
    <message>
        <source>Pattern: %1</source>
        <translation>规律：%1</translation>
    </message>
    <message>
        <source>%1 % of the gap</source>
        <translation>差距的 %1 %</translation>
    </message>
    <message>
        <source>in the model</source>
        <translation>已在模型中</translation>
    </message>
    <message>
        <source>Probabilities: given the catalogue and the plausible sizes of its effects.</source>
        <translation>概率：以目录及其效应的合理大小为前提。</translation>
    </message>
    <message>
        <source>Probabilities: given the catalogue and the plausible sizes of its effects (1σ: %1).</source>
        <extracomment>%1: effects with their sizes, &quot;collimation 30″, refraction 2″&quot;</extracomment>
        <translation>概率：以目录及其效应的合理大小（1σ：%1）为前提。</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Cause or form</source>
        <translation>原因或形式</translation>
    </message>
    <message>
        <source>size ± U</source>
        <translation>大小 ± U</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>change of the gap</source>
        <translation>差距的变化</translation>
    </message>
    <message>
        <source>indistinguishable</source>
        <translation>无法与之区分</translation>
    </message>
    <message>
        <source>No effect of the catalogue makes this pattern, so nothing can be added to the model: look for something of this shape in the set-up.</source>
        <translation>目录中没有效应会造成此规律，因此没有可加入模型的内容：请检查设站与设备中什么具有这种形状。</translation>
    </message>
    <message>
        <source>Form of the gap</source>
        <translation>差距的形式</translation>
    </message>
    <message>
        <source>A form describes the readings; it does not name their cause.</source>
        <translation>形式说明读数怎样变化，并不指明其原因。</translation>
    </message>
    <message>
        <source>If the arc is rigid, half a turn about an axis along x changes neither its radius nor the x of its centre, and an arc measured again has not moved. R0 and the reference are compared if their σ is stated. U at a coverage of %1 %.</source>
        <translation>若圆弧为刚性，绕 x 方向的轴转半圈时其半径和圆心的 x 均不变，复测的圆弧仍在原处。给定 σ 时，R0 和参考值也参与比较。U 的包含概率为 %1 %。</translation>
    </message>
    <message>
        <source>If the arc is rigid, half a turn about an axis along x changes neither its radius nor the x of its centre. R0 and the reference are compared if their σ is stated. U at a coverage of %1 %.</source>
        <translation>若圆弧为刚性，绕 x 方向的轴转半圈时其半径和圆心的 x 均不变。给定 σ 时，R0 和参考值也参与比较。U 的包含概率为 %1 %。</translation>
    </message>
    <message>
        <source>Both positions are needed to compare them.</source>
        <translation>需要两个轴位才能比较。</translation>
    </message>
    <message>
        <source>With the causes in the model, these quantities agree.</source>
        <translation>原因计入模型后，各量一致。</translation>
    </message>
    <message>
        <source>For one rigid arc turned about a level axis, these quantities agree.</source>
        <translation>按同一刚性圆弧绕水平轴转动计，各量一致。</translation>
    </message>
    <message>
        <source>Closures: what must agree</source>
        <translation>闭合差：必须一致的量</translation>
    </message>
    <message>
        <source>Closure</source>
        <translation>闭合差</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>with the causes ± U</source>
        <translation>计入原因 ± U</translation>
    </message>
    <message>
        <source>Known sizes of instrument and device</source>
        <translation>仪器和设备的已知值</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Known size</source>
        <translation>已知值</translation>
    </message>
    <message>
        <source>these readings</source>
        <translation>这些读数</translation>
    </message>
    <message>
        <source>known from</source>
        <translation>已知来源</translation>
    </message>
    <message>
        <source>Each value enters the uncertainty and the search for causes with its u; the prior probability that it is out of date is one in fifty. A dash: these readings are too weak to check it.</source>
        <translation>每个值以其 u 计入不确定度，并用于查找原因；其已过时的先验概率为五十分之一。短横表示这些读数不足以检核该值。</translation>
    </message>
    <message>
        <source>Sizes that would explain Δd − reference</source>
        <translation>解释 Δd − 参考值所需的大小</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>trace (σ)</source>
        <translation>留痕 (σ)</translation>
    </message>
    <message>
        <source>Effects, each considered alone, that these readings do not exclude at that size, the most plausible first; trace: what the effect would leave in these readings.</source>
        <translation>逐个考虑这些读数在该大小下未能排除的效应，最合理的在前；留痕：它会在这些读数中留下的痕迹。</translation>
    </message>
    <message>
        <source>without the misread value</source>
        <translation>去掉误读值</translation>
    </message>
    <message>
        <source>without 1 misread value</source>
        <translation>去掉 1 个误读值</translation>
    </message>
    <message>
        <source>without %1 misread values</source>
        <translation>去掉 %1 个误读值</translation>
    </message>
    <message>
        <source>without model effects</source>
        <translation>不含模型效应</translation>
    </message>
    <message>
        <source>+ known sizes</source>
        <translation>+ 已知值</translation>
    </message>
    <message>
        <source>in the model: %1</source>
        <translation>已在模型中：%1</translation>
    </message>
    <message>
        <source>Δd with the form is averaged over the indistinguishable forms; their cause is unknown.</source>
        <translation>含此形式的 Δd 是对无法区分的各形式取的平均；其原因未知。</translation>
    </message>
    <message>
        <source>U includes the possible effect of the pattern on Δd; the cause of the pattern is unknown.</source>
        <translation>U 包含该规律可能使 Δd 改变的量；该规律的原因不明。</translation>
    </message>
    <message>
        <source>Δd with the causes is averaged over all possible explanations, weighted by their probabilities; the first alone would give too small a U.</source>
        <translation>计入原因的 Δd 按概率对所有可能的解释取加权平均；只取第一个会使 U 偏小。</translation>
    </message>
    <message>
        <source>The residuals shrink by %1 %, by %2 % on readings held out of the fit.</source>
        <translation>残差减小 %1 %，在未参与拟合的留出读数上减小 %2 %。</translation>
    </message>
    <message>
        <source>The residuals shrink by %1 %; there are too few readings to hold any out of the fit.</source>
        <translation>残差减小 %1 %；读数太少，无法留出任何读数。</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>之前与之后</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>rms ″</source>
        <translation>均方根 ″</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Undetectable here</source>
        <translation>在此无法检出</translation>
    </message>
    <message>
        <source>moves Δd (mm)</source>
        <translation>使 Δd 改变 (mm)</translation>
    </message>
    <message>
        <source>An effect of plausible size that moved Δd noticeably would leave a trace.</source>
        <translation>合理大小的效应若明显改变 Δd，必会留下痕迹。</translation>
    </message>
    <message>
        <source>The diagnosis was stopped. The next edit starts it again.</source>
        <translation>诊断已停止。下次编辑会重新开始。</translation>
    </message>
    <message>
        <source>The positions do not agree</source>
        <translation>各轴位不闭合</translation>
    </message>
    <message>
        <source>No gap: within the noise</source>
        <translation>无差距：在噪声之内</translation>
    </message>
    <message>
        <source>One cause: %1</source>
        <translation>一个原因：%1</translation>
    </message>
    <message>
        <source>One of %1 causes indistinguishable here</source>
        <translation>在此无法区分的 %1 个原因之一</translation>
    </message>
    <message>
        <source>More causes than these readings can separate</source>
        <translation>原因多于这些读数所能区分的数目</translation>
    </message>
    <message>
        <source>%1 causes</source>
        <translation>%1 个原因</translation>
    </message>
    <message>
        <source>A gap of no known cause</source>
        <translation>原因不明的差距</translation>
    </message>
    <message>
        <source>An unknown cause and %1</source>
        <translation>除%1外还有未知原因</translation>
    </message>
    <message>
        <source>An unknown cause and %1 known ones</source>
        <translation>除 %1 个已知原因外还有未知原因</translation>
    </message>
    <message>
        <source>a jump of the orientation</source>
        <translation>定向的突跳</translation>
    </message>
    <message>
        <source>misread values</source>
        <translation>误读值</translation>
    </message>
    <message>
        <source>noise larger than stated</source>
        <translation>大于给定值的噪声</translation>
    </message>
    <message>
        <source>the form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>the vertical angle relation</source>
        <translation>竖直角关系式</translation>
    </message>
    <message>
        <source>%1, and %2 more</source>
        <translation>%1，以及另外 %2 种</translation>
    </message>
    <message>
        <source>export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>acceptance report</source>
        <translation>验收报告</translation>
    </message>
    <message>
        <source>reading of the files</source>
        <translation>文件读取</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>search for misread readings</source>
        <translation>误读读数的查找</translation>
    </message>
    <message>
        <source>instrument check</source>
        <translation>仪器检查</translation>
    </message>
    <message>
        <source>forecast of U</source>
        <translation>U 的预估</translation>
    </message>
    <message>
        <source>series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>blind trial</source>
        <translation>盲测</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>With one rigid arc in both positions: %1</source>
        <translation>两个轴位按同一刚性圆弧计：%1</translation>
    </message>
    <message>
        <source>α0(%1) − first α0</source>
        <translation>α0(%1) − 首个 α0</translation>
    </message>
    <message>
        <source>β0(%1) − first β0</source>
        <translation>β0(%1) − 首个 β0</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>待定</translation>
    </message>
    <message>
        <source>tolerance %1 mm</source>
        <translation>允差 %1 mm</translation>
    </message>
    <message>
        <source>tolerance ± %1 mm</source>
        <translation>允差 ± %1 mm</translation>
    </message>
    <message>
        <source>%1 ± %2 mm</source>
        <translation>%1 ± %2 mm</translation>
    </message>
    <message>
        <source>Δd = %1 mm, U = %2 mm</source>
        <translation>Δd = %1 mm，U = %2 mm</translation>
    </message>
    <message>
        <source>%1 at %2 % coverage.
Includes every catalogued effect, limited by these readings or by its plausible size. The page Budget lists what each contributes.
%3</source>
        <translation>%1，包含概率 %2 %。
包含目录中的每个效应，其大小受这些读数或其合理大小限定。各效应的贡献见“不确定度预算”页。
%3</translation>
    </message>
    <message>
        <source>Δd</source>
        <translation>Δd</translation>
    </message>
    <message>
        <source>Δd, fit only: %1</source>
        <translation>Δd，仅拟合：%1</translation>
    </message>
    <message>
        <source>U at %1 % coverage (k = %2); u = %3 mm</source>
        <translation>包含概率 %1 % 的 U（k = %2）；u = %3 mm</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>不作判定</translation>
    </message>
    <message>
        <source>No tolerance is stated, so there is no verdict.</source>
        <translation>未给出允差，因此不作判定。</translation>
    </message>
    <message>
        <source>%1, fit only</source>
        <translation>%1，仅拟合</translation>
    </message>
    <message>
        <source>The intersection needs an arc at 0° and an arc at 180°; at least one is missing.</source>
        <translation>相交度需要 0° 和 180° 各一个圆弧；至少缺少一个。</translation>
    </message>
    <message>
        <source>No result</source>
        <translation>没有结果</translation>
    </message>
    <message>
        <source>No verdict: 1 entry could not be used</source>
        <translation>不作判定：有 1 个输入项无法使用</translation>
    </message>
    <message>
        <source>No verdict: %1 entries could not be used</source>
        <translation>不作判定：有 %1 个输入项无法使用</translation>
    </message>
    <message>
        <source>Entries that cannot be used are listed with their place. Correct each or exclude its reading: the result stated here uses only the other entries.</source>
        <translation>无法使用的项已连同位置列出。请改正，或排除其读数：此处的结果仅依据其余读数。</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Provisional: the diagnosis is running.</source>
        <translation>暂定：诊断正在进行。</translation>
    </message>
    <message>
        <source>Across the plane of the arc: Δz was not measured</source>
        <translation>垂直于圆弧平面：Δz 未测量</translation>
    </message>
    <message>
        <source>In the plane of the arc Δd = %1, perpendicular to it Δz = %2</source>
        <translation>圆弧平面内 Δd = %1，垂直于该平面 Δz = %2</translation>
    </message>
    <message>
        <source>Across the plane of the arc: Δz = %1, not judged (the tolerance is of Δd)</source>
        <translation>垂直于圆弧平面：Δz = %1，不作判定（允差针对 Δd）</translation>
    </message>
    <message>
        <source>Across the plane of the arc: Δz = %1</source>
        <translation>垂直于圆弧平面：Δz = %1</translation>
    </message>
    <message>
        <source>Model and readings disagree, and no catalogued effect explains it</source>
        <translation>模型与读数不符，且没有目录中的效应可以解释</translation>
    </message>
    <message>
        <source>Model and readings disagree because of more causes than these readings can separate</source>
        <translation>模型与读数不符，其原因多于这些读数所能区分的</translation>
    </message>
    <message>
        <source>The readings scatter more than stated; U includes this</source>
        <translation>读数的离散大于给定值，U 已将其计入</translation>
    </message>
    <message>
        <source>Model and readings disagree, best explained by %1</source>
        <translation>模型与读数不符，最佳解释是%1</translation>
    </message>
    <message>
        <source>1 other</source>
        <translation>另外 1 项</translation>
    </message>
    <message>
        <source>%1 mm (u %2 mm)</source>
        <translation>%1 mm（u %2 mm）</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Reference %1: difference %2</source>
        <translation>参考值 %1：差值 %2</translation>
    </message>
    <message>
        <source>Reference %1: difference %2, agrees (E_n %3)</source>
        <translation>参考值 %1：差值 %2，一致（E_n %3）</translation>
    </message>
    <message>
        <source>Reference %1: difference %2, disagrees (E_n %3)</source>
        <translation>参考值 %1：差值 %2，不一致（E_n %3）</translation>
    </message>
    <message>
        <source>the radii differ by %1 σ</source>
        <translation>两个半径相差 %1 σ</translation>
    </message>
    <message>
        <source>Δx differs by %1 σ</source>
        <translation>Δx 相差 %1 σ</translation>
    </message>
    <message>
        <source>R and R0 differ by %1 σ</source>
        <translation>R 与 R0 相差 %1 σ</translation>
    </message>
    <message>
        <source>Δd and the reference differ by %1 σ</source>
        <translation>Δd 与参考值相差 %1 σ</translation>
    </message>
    <message>
        <source>the pointing zeros differ horizontally by %1 σ</source>
        <translation>瞄准零位水平方向相差 %1 σ</translation>
    </message>
    <message>
        <source>the pointing zeros differ vertically by %1 σ</source>
        <translation>瞄准零位竖直方向相差 %1 σ</translation>
    </message>
    <message>
        <source>%1 differs from zero by %2 σ</source>
        <translation>%1 与零相差 %2 σ</translation>
    </message>
    <message>
        <source>an unknown cause</source>
        <translation>一个未知原因</translation>
    </message>
    <message>
        <source>The verdict depends on a single row: %1</source>
        <translation>判定取决于单行读数：%1</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>期望值</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>所得值</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最大允许</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>离群值</translation>
    </message>
    <message>
        <source>EWMA outside</source>
        <translation>EWMA 超限</translation>
    </message>
    <message>
        <source>one value</source>
        <translation>一个值</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>scatters</source>
        <translation>离散</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>已改变</translation>
    </message>
    <message>
        <source>device changed</source>
        <translation>设备有变化</translation>
    </message>
    <message>
        <source>O1 and O2 refer to the theodolite: compare them only between set-ups on the same pillar.</source>
        <translation>O1 与 O2 以经纬仪为基准：只能在同一观测墩的各次设站之间比较。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值数</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>± limit</source>
        <translation>± 限值</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>测量记录</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>测量记录</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>各量</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Weighted mean</source>
        <translation>加权均值</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>走势</translation>
    </message>
    <message>
        <source>Sessions compared</source>
        <translation>测量记录比较</translation>
    </message>
    <message>
        <source>From</source>
        <translation>由</translation>
    </message>
    <message>
        <source>To</source>
        <translation>变为</translation>
    </message>
    <message>
        <source>Δd changes by</source>
        <translation>Δd 变化</translation>
    </message>
    <message>
        <source>Device: T, number</source>
        <translation>设备：T，个数</translation>
    </message>
    <message>
        <source>Each session is compared with the next, and the first with the last. Δd, measured, has its expanded uncertainty; effects common to both sessions cancel. Device: d holds the m changes of (O1 − O2)/2 and of the radii, from the readings alone; T = dᵀC⁻¹d with the full covariance C of both fits.</source>
        <translation>每份测量记录与下一份、第一份与最后一份相比。实测 Δd 附其扩展不确定度；两份测量记录共有的部分相消。设备：d 为仅由读数得出的 (O1 − O2)/2 和半径的 m 个变化；T = dᵀC⁻¹d，C 为两次拟合的完整协方差。</translation>
    </message>
    <message>
        <source>device without a name</source>
        <translation>未命名的设备</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1，序列号 %2</translation>
    </message>
    <message>
        <source>all, pooled</source>
        <translation>全部合并</translation>
    </message>
    <message>
        <source>%1, by round</source>
        <translation>%1，按测回</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>照准差</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>指标差</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>定向</translation>
    </message>
    <message>
        <source>%1, by target</source>
        <translation>%1，按目标</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>高度角</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>s of a direction observed once in both faces, with its degrees of freedom</source>
        <translation>盘左、盘右各观测一次的方向的 s，及其自由度</translation>
    </message>
    <message>
        <source>s of a zenith angle observed once in both faces, with its degrees of freedom</source>
        <translation>盘左、盘右各观测一次的天顶距的 s，及其自由度</translation>
    </message>
    <message>
        <source>Field check after ISO 17123-3</source>
        <translation>按 ISO 17123-3 的现场检验</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>测站</translation>
    </message>
    <message>
        <source>Each station is evaluated separately; the last row pools all stations</source>
        <translation>各测站分别评定；最后一行为全部测站合并</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Complete rounds × targets</source>
        <translation>完整测回数 × 目标数</translation>
    </message>
    <message>
        <source>s direction (ν)</source>
        <translation>方向 s (ν)</translation>
    </message>
    <message>
        <source>s zenith (ν)</source>
        <translation>天顶距 s (ν)</translation>
    </message>
    <message>
        <source>c, with the sign of face 1, ± its standard uncertainty</source>
        <translation>c（按盘左），± 其标准不确定度</translation>
    </message>
    <message>
        <source>Index of the vertical circle, sign of face 1, ± its standard uncertainty</source>
        <translation>竖直度盘的指标差（按盘左），± 其标准不确定度</translation>
    </message>
    <message>
        <source>Trunnion tilt</source>
        <translation>横轴误差</translation>
    </message>
    <message>
        <source>i, estimated together with the collimation, from targets at several elevations</source>
        <translation>i：根据多个高度角的目标，连同照准差一起估计</translation>
    </message>
    <message>
        <source>Line of sight</source>
        <translation>视线</translation>
    </message>
    <message>
        <source>Offset e of the line of sight from the vertical axis, determined from targets at several distances</source>
        <translation>视线偏离竖轴的量 e，由不同距离的目标得出</translation>
    </message>
    <message>
        <source>Rounds × targets; s: of a direction or a zenith angle observed once in both faces, ν: degrees of freedom. Collimation and index as of face 1; line of sight: its distance from the axis; each ± its standard uncertainty.</source>
        <translation>测回 × 目标；s：盘左、盘右各观测一次的方向或天顶距，ν：自由度。照准差和指标差按盘左；视线：到竖轴的距离；均 ± 标准不确定度。</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <extracomment>an arc and the position of its axis</extracomment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Arc centres and radii</source>
        <translation>圆心和半径</translation>
    </message>
    <message>
        <source>Δx (u), mm</source>
        <translation>Δx (u)，mm</translation>
    </message>
    <message>
        <source>Centre of the arc, right positive, with its standard uncertainty</source>
        <translation>圆弧圆心，向右为正，及其标准不确定度</translation>
    </message>
    <message>
        <source>Δy (u), mm</source>
        <translation>Δy (u)，mm</translation>
    </message>
    <message>
        <source>Centre of the arc, up positive, with its standard uncertainty</source>
        <translation>圆弧圆心，向上为正，及其标准不确定度</translation>
    </message>
    <message>
        <source>R (u), mm</source>
        <translation>R (u)，mm</translation>
    </message>
    <message>
        <source>Fitted radius with its standard uncertainty</source>
        <translation>拟合半径及其标准不确定度</translation>
    </message>
    <message>
        <source>Sightings</source>
        <translation>照准数</translation>
    </message>
    <message>
        <source>rms, ″</source>
        <translation>均方根，″</translation>
    </message>
    <message>
        <source>Root mean square of the residuals of all readings of the arc</source>
        <translation>圆弧所有读数残差的均方根</translation>
    </message>
    <message>
        <source>Reduced χ²</source>
        <translation>约化 χ²</translation>
    </message>
    <message>
        <source>About 1 where the readings scatter as stated</source>
        <translation>读数按给定值离散时约为 1</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation>多余观测分量</translation>
    </message>
    <message>
        <source>Half the distance of the centres: |O1 − O2|/2 = %1.</source>
        <translation>圆弧平面内两圆心距离的一半：|O1 − O2|/2 = %1。</translation>
    </message>
    <message>
        <source>x right, y up; u: standard, scaled by s0 = %1; rms: of all residuals.</source>
        <translation>x 向右，y 向上；u：标准不确定度，按 s0 = %1 缩放；均方根：全部残差。</translation>
    </message>
    <message>
        <source>Positions at the same axis angle share one centre and one radius.</source>
        <translation>轴角相同的轴位共用一个圆心和一个半径。</translation>
    </message>
    <message>
        <source>Published method, as printed</source>
        <translation>已发表的方法（按原文）</translation>
    </message>
    <message>
        <source>Δd as printed = %1 mm; with y up %2 mm; |O1 − O2|/2 = %3 mm.</source>
        <translation>按原文 Δd = %1 mm；y 向上时为 %2 mm；|O1 − O2|/2 = %3 mm。</translation>
    </message>
    <message>
        <source>As printed: y points down for zenith angles, ΔR is the last increment, θ are not tilts. The method states no uncertainty and assumes tan e = y/L, but no theodolite reads this angle e; do not accept a guideway by this method.</source>
        <translation>按原文：对天顶距 y 向下，ΔR 为最后一次增量，θ 不是倾斜。该方法不给出不确定度，并采用 tan e = y/L，而没有经纬仪读取这样的角 e；请勿据此方法验收。</translation>
    </message>
    <message>
        <source>Model effects</source>
        <translation>模型效应</translation>
    </message>
    <message>
        <source>Estimated along with the arcs</source>
        <translation>与圆弧一并估计</translation>
    </message>
    <message>
        <source>Standard uncertainty of the centres (mm)</source>
        <translation>圆心的标准不确定度（mm）</translation>
    </message>
    <message>
        <source>correlation with R</source>
        <translation>与 R 的相关</translation>
    </message>
    <message>
        <source>Correlation with R, −1 to 1: how strongly an error of the radius shifts the centre; on half an arc, R determines the height of the centre.</source>
        <translation>与 R 的相关系数：半径有误时圆心随之移动的程度，−1 至 1；在半个圆弧上，R 决定圆心的高度。</translation>
    </message>
    <message>
        <source>U: coverage %1.</source>
        <translation>U：包含概率 %1。</translation>
    </message>
    <message>
        <source>Δd, measured: u = %1, ν = %2.</source>
        <translation>Δd，实测：u = %1，ν = %2。</translation>
    </message>
    <message>
        <source>%1, k = %2, u = %3, ν = %4.</source>
        <translation>%1，k = %2，u = %3，ν = %4。</translation>
    </message>
    <message>
        <source>Journal of changes</source>
        <translation>更改日志</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>1 earlier entry is in the session file.</source>
        <translation>测量记录文件中还有 1 条更早的更改。</translation>
    </message>
    <message>
        <source>%1 earlier entries are in the session file.</source>
        <translation>测量记录文件中还有 %1 条更早的更改。</translation>
    </message>
    <message>
        <source>With these draws, an end of the interval is uncertain by %1: a decision needs about %2 draws.</source>
        <translation>以目前的抽样，一个端点的不确定度为 %1：约需 %2 次抽样才能判断。</translation>
    </message>
    <message>
        <source>With these draws, an end of the interval is uncertain by %1: a decision needs more draws than can be set here.</source>
        <translation>以目前的抽样，一个端点的不确定度为 %1；所需抽样次数超过此处可设的上限，无法判断。</translation>
    </message>
    <message>
        <source>Monte Carlo check of Δd, fit only</source>
        <translation>仅拟合 Δd 的蒙特卡洛检验</translation>
    </message>
    <message>
        <source>mean (mm)</source>
        <translation>均值（mm）</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 区间自</translation>
    </message>
    <message>
        <source>to (mm)</source>
        <translation>至（mm）</translation>
    </message>
    <message>
        <source>Δd, propagated</source>
        <translation>Δd，传播律</translation>
    </message>
    <message>
        <source>Δd, simulated</source>
        <translation>Δd，模拟</translation>
    </message>
    <message>
        <source>JCGM 101: %1 draws of all readings, seed %2; the centres are those simulated.</source>
        <translation>JCGM 101：对全部读数抽样 %1 次，种子 %2；圆心为模拟值。</translation>
    </message>
    <message>
        <source>Agrees.</source>
        <translation>一致。</translation>
    </message>
    <message>
        <source>Does not agree.</source>
        <translation>不一致。</translation>
    </message>
    <message>
        <source>No disagreement, but too few draws to be sure.</source>
        <translation>没有不一致，但抽样次数太少，不能确定。</translation>
    </message>
    <message>
        <source>The ends of Δd ± U differ by %1 and %2 from the simulated ends; the numerical tolerance is %3.</source>
        <translation>Δd ± U 的端点与模拟值相差 %1 和 %2；数值容差为 %3。</translation>
    </message>
    <message>
        <source>Rely on the simulated interval.</source>
        <translation>请采用模拟区间。</translation>
    </message>
    <message>
        <source>horizontal zero</source>
        <translation>水平零位</translation>
    </message>
    <message>
        <source>vertical zero</source>
        <translation>竖直零位</translation>
    </message>
    <message>
        <source>%1 per mm</source>
        <translation>每 mm %1</translation>
    </message>
    <message>
        <source>%1 per ″</source>
        <translation>每 ″ %1</translation>
    </message>
    <message>
        <source>Too few readings: no reading is checked by the others well enough to show whether it is misread.</source>
        <translation>读数太少：没有一个读数被其他读数充分检核到能判断误读。</translation>
    </message>
    <message>
        <source>Every reading is checked.</source>
        <translation>每个读数都有检核。</translation>
    </message>
    <message>
        <source>Every reading is checked. An undetected error has the largest effect in %1: an error of up to %2″ moves Δd by up to %3 mm.</source>
        <translation>每个读数都有检核。未被发现的误差在%1影响最大：该处不超过 %2″ 的误差使 Δd 改变至多 %3 mm。</translation>
    </message>
    <message>
        <source>Nothing checks the pointing zeros and the distance.</source>
        <translation>瞄准零位和距离没有检核。</translation>
    </message>
    <message>
        <source>Nothing checks the distance.</source>
        <translation>距离没有检核。</translation>
    </message>
    <message>
        <source>Reliability</source>
        <translation>可靠性</translation>
    </message>
    <message>
        <source>residual ″</source>
        <translation>残差 ″</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>多余观测分量</translation>
    </message>
    <message>
        <source>detectable ″</source>
        <translation>可检测 ″</translation>
    </message>
    <message>
        <source>moves Δd by mm</source>
        <translation>Δd 的改变 mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>w: standardised residual; redundancy: share of an error that shows in the residual; detectable: the smallest error that the search for misread readings finds with a probability of 80 %; moves Δd by: the effect of such an error.</source>
        <translation>w：标准化残差；多余观测分量：误差显现于残差的份额；可检测：查找误读时以 80 % 的概率能发现的最小误差；Δd 的改变由此误差引起。</translation>
    </message>
    <message>
        <source>Readings that look misread</source>
        <translation>像是误读的读数</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>probably meant</source>
        <translation>可能应为</translation>
    </message>
    <message>
        <source>or</source>
        <translation>或</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>另有 %1 个。</translation>
    </message>
    <message>
        <source>From both faces</source>
        <translation>由两盘位得出</translation>
    </message>
    <message>
        <source>value (u), ″</source>
        <translation>值 (u)，″</translation>
    </message>
    <message>
        <source>With standard uncertainty; signs of face 1. A trunnion tilt needs three visits at different elevations</source>
        <translation>附标准不确定度；符号按盘左。横轴误差需要在不同高度角的三次停靠</translation>
    </message>
    <message>
        <source>scatter against the stated σ</source>
        <translation>离散与给定 σ 之比</translation>
    </message>
    <message>
        <source>About × 1 where the differences of the faces scatter as stated</source>
        <translation>两盘位之差按给定值离散时约为 × 1</translation>
    </message>
    <message>
        <source>collimation c</source>
        <translation>照准差 c</translation>
    </message>
    <message>
        <source>trunnion tilt i</source>
        <translation>横轴误差 i</translation>
    </message>
    <message>
        <source>vertical index j</source>
        <translation>竖盘指标差 j</translation>
    </message>
    <message>
        <source>Signs of face 1. Visits read in both faces: %1.</source>
        <translation>符号按盘左。双盘位读取的停靠：%1 次。</translation>
    </message>
    <message>
        <source>Both faces</source>
        <translation>双盘位</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Elevation °</source>
        <translation>高度角 °</translation>
    </message>
    <message>
        <source>2c residual ″</source>
        <translation>2c 残差 ″</translation>
    </message>
    <message>
        <source>Index ″</source>
        <translation>指标差 ″</translation>
    </message>
    <message>
        <source>More than one reading may be wrong here: read it again.</source>
        <translation>此处可能不止一个读数有误：请重新读取。</translation>
    </message>
    <message>
        <source>No single gross error explains the value: read it again.</source>
        <translation>没有单一的粗差能解释该值：请重新读取。</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <extracomment>the name of a reading, how wrong it is, and what was probably meant or has to be done</extracomment>
        <translation>%1：%2。%3</translation>
    </message>
    <message>
        <source>%1 is no order of sightings: write %2 or %3</source>
        <translation>%1 不是照准顺序：请写 %2 或 %3</translation>
    </message>
    <message>
        <source>no cause</source>
        <translation>无原因</translation>
    </message>
    <message>
        <source>%1 is most informative per minute (it takes %2 min): it separates %3 from %4.</source>
        <translation>按每分钟的信息量，%1 最佳（需 %2 min）：可区分%3与%4。</translation>
    </message>
    <message>
        <source>%1 is most informative per minute (it takes %2 min): it reduces U by %3.</source>
        <translation>按每分钟的信息量，%1 最佳（需 %2 min）：可使 U 减小 %3。</translation>
    </message>
    <message>
        <source>Nearly as informative: %1.</source>
        <translation>信息量相近的还有：%1。</translation>
    </message>
    <message>
        <source>more than 1 000 000</source>
        <translation>1 000 000 以上</translation>
    </message>
    <message>
        <source>Not enough yet: the Bayes factor for a cause is %1 to 1; %2 to 1 is needed.</source>
        <translation>尚不足够：有原因相对“无原因”的贝叶斯因子为 %1 : 1，需要 %2 : 1。</translation>
    </message>
    <message>
        <source>Not enough yet: the Bayes factor for a cause is %1 to 1, but no single cause is probable enough.</source>
        <translation>尚不足够：有原因相对“无原因”的贝叶斯因子为 %1 : 1，但没有哪一个原因的概率足够大。</translation>
    </message>
    <message>
        <source>Possible explanations</source>
        <translation>可能的解释</translation>
    </message>
    <message>
        <source>Before the end, sight %1: an effect of time shows only if an early place is sighted again.</source>
        <translation>结束前照准 %1，因为只有再次照准较早的位置，随时间变化的效应才会显现。</translation>
    </message>
    <message>
        <source>Before the end, sight %1: an effect of time shows only if the zero is sighted again.</source>
        <translation>结束前照准 %1，因为只有再次照准瞄准零位，随时间变化的效应才会显现。</translation>
    </message>
    <message>
        <source>U of Δd is already below %1 mm, whatever effect is present.</source>
        <translation>无论存在何种效应，Δd 的 U 已低于 %1 mm。</translation>
    </message>
    <message>
        <source>U = %1 mm of Δd, whatever effect is present, needs further sightings: %2, in %3 min.</source>
        <translation>要使 Δd 的 U 在任何效应下达到 %1 mm：还需照准 %2 次，共 %3 min。</translation>
    </message>
    <message>
        <source>The protocol has no position left at the other axis angle: Δd needs readings at 0° and at 180°.</source>
        <translation>方案中另一轴角已没有剩余轴位：Δd 需要 0° 和 180° 两处的读数。</translation>
    </message>
    <message>
        <source>U = %1 mm of Δd is not reached: %2 more sightings give %3 mm.</source>
        <translation>Δd 的 U 达不到 %1 mm：再照准 %2 次可达 %3 mm。</translation>
    </message>
    <message>
        <source>Sightings to come</source>
        <translation>待照准</translation>
    </message>
    <message>
        <source>points</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Not enough yet: the readings scatter more than stated, from noise or an uncatalogued effect; the diagnosis shows which.</source>
        <translation>尚不足够：读数的离散大于给定值，原因可能是噪声，也可能是目录之外的效应；由诊断给出是哪一种。</translation>
    </message>
    <message>
        <source>k = %1, %2 coverage</source>
        <translation>k = %1，包含概率 %2</translation>
    </message>
    <message>
        <source>fit only ± U</source>
        <translation>仅拟合 ± U</translation>
    </message>
    <message>
        <source>fit only</source>
        <translation>仅拟合</translation>
    </message>
    <message>
        <source>%1 of %2 readings are hardly checked by others (redundancy below %3): an error in them would not show.</source>
        <translation>%2 个读数中有 %1 个没有或几乎没有其他读数检核（多余观测分量低于 %3）：其中的错误不会显现。</translation>
    </message>
    <message>
        <source>has no readings yet</source>
        <translation>还没有读数</translation>
    </message>
    <message>
        <source>averaged over the indistinguishable causes</source>
        <translation>对无法区分的原因取平均</translation>
    </message>
    <message>
        <source>The gap is best explained by %1 or by an indistinguishable cause: %2. %3</source>
        <translation>差距的最佳解释是%1，或无法与其区分的原因：%2。%3</translation>
    </message>
    <message>
        <source>reason stated</source>
        <translation>说明了原因</translation>
    </message>
    <message>
        <source>%1, with one unsealed change since</source>
        <translation>%1；此后有 1 处更改尚未封存</translation>
    </message>
    <message>
        <source>%1, with %2 unsealed changes since</source>
        <translation>%1；此后有 %2 处更改尚未封存</translation>
    </message>
    <message>
        <source>a return run</source>
        <translation>返测</translation>
    </message>
    <message>
        <source>%1 (in a new session)</source>
        <translation>%1（在新的测量记录中）</translation>
    </message>
    <message>
        <source>no places</source>
        <translation>没有位置</translation>
    </message>
    <message>
        <source>%1 to %2 places</source>
        <translation>%1 至 %2 个位置</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 个位置</translation>
    </message>
    <message>
        <source>%1 places</source>
        <translation>%1 个位置</translation>
    </message>
    <message>
        <source>one face</source>
        <translation>单盘位</translation>
    </message>
    <message>
        <source>one face per round</source>
        <translation>每测回一个盘位</translation>
    </message>
    <message>
        <source>both faces in some rounds</source>
        <translation>部分测回为双盘位</translation>
    </message>
    <message>
        <source>back only</source>
        <translation>仅返测</translation>
    </message>
    <message>
        <source>there only</source>
        <translation>仅往测</translation>
    </message>
    <message>
        <source>up to %1 rounds</source>
        <translation>至多 %1 个测回</translation>
    </message>
    <message>
        <source>%1 rounds</source>
        <translation>%1 个测回</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>往返测</translation>
    </message>
    <message>
        <source>%1 rounds, there and back</source>
        <translation>%1 个测回，往返</translation>
    </message>
    <message>
        <source>only at %1°</source>
        <translation>仅在 %1°</translation>
    </message>
    <message>
        <source>both positions again</source>
        <translation>两个轴位各再测一次</translation>
    </message>
    <message>
        <source>with slider readings</source>
        <translation>含滑块读数</translation>
    </message>
    <message>
        <source>the circle turned between positions</source>
        <translation>轴位之间转动度盘</translation>
    </message>
    <message>
        <source>each sighting chosen by its information</source>
        <translation>每次照准按信息量选定</translation>
    </message>
    <message>
        <source>Skipped: %1.</source>
        <translation>跳过：%1。</translation>
    </message>
    <message>
        <source>Taken out of order: %1.</source>
        <translation>未按顺序：%1。</translation>
    </message>
    <message>
        <source>Taken again: %1.</source>
        <translation>重测：%1。</translation>
    </message>
    <message>
        <source>Excluded: %1.</source>
        <translation>排除：%1。</translation>
    </message>
    <message>
        <source>The report says “not stated” for: %1.</source>
        <translation>报告中下列内容标为“未说明”：%1。</translation>
    </message>
    <message>
        <source>1σ: plausible size of each effect; c: sensitivity, the change of Δd in mm per unit of the effect in these readings; ν: degrees of freedom; share: of the variance. A: from the scatter of these readings; B: from other knowledge.</source>
        <translation>1σ：每项效应的合理大小；c：灵敏系数，即其一个单位在这些读数中使 Δd 改变多少毫米；ν：自由度；占比：占方差的比例。A：由这些读数的离散得出；B：由其他信息得出。</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>no certificate is made: ISO/IEC 17025 and the schema require the missing entries: %1</source>
        <translation>未出具证书：缺少 ISO/IEC 17025 和证书格式要求说明的内容：%1</translation>
    </message>
    <message>
        <source>Every reading as it was entered, and the results in full, are attached as files.</source>
        <translation>录入的全部读数和完整的结果均以文件形式附上。</translation>
    </message>
    <message>
        <source>From %1 on the value is larger by %2.</source>
        <translation>自 %1 起该值增大 %2。</translation>
    </message>
    <message>
        <source>From %1 on the value is smaller by %2.</source>
        <translation>自 %1 起该值减小 %2。</translation>
    </message>
    <message>
        <source>The value changes steadily, by %1.</source>
        <translation>该值持续变化，变化率 %1。</translation>
    </message>
    <message>
        <source>Baseline: the value of %1, %2.</source>
        <translation>基准阶段：%1 的值，%2。</translation>
    </message>
    <message>
        <source>Baseline: %1 values from %2 to %3, centre line %4.</source>
        <translation>基准阶段：%2 至 %3 的 %1 个值，中心线 %4。</translation>
    </message>
    <message>
        <source>%1 Later values outside their limits: %2 of %3, the first on %4.</source>
        <translation>%1 其后超出控制限的值：%3 个中 %2 个，首次在 %4。</translation>
    </message>
    <message>
        <source>%1 Later values outside their limits: 0 of %2, but their average (EWMA) leaves its limits on %3.</source>
        <translation>%1 其后超出控制限的值：%2 个中 0 个，但其平均（EWMA）在 %3 越出自身的控制限。</translation>
    </message>
    <message>
        <source>%1 Later values outside their limits: 0 of %2.</source>
        <translation>%1 其后超出控制限的值：%2 个中 0 个。</translation>
    </message>
    <message>
        <source>expanded uncertainty, %1</source>
        <translation>扩展不确定度，%1</translation>
    </message>
    <message>
        <source>Value: %1 (%2).</source>
        <translation>值：%1（%2）。</translation>
    </message>
    <message>
        <source>Weighted mean of %1 values: %2 (%3).</source>
        <translation>%1 个值的加权均值：%2（%3）。</translation>
    </message>
    <message>
        <source>From the observed scatter, the expanded uncertainty of the mean is %1.</source>
        <translation>按观测到的离散，均值的扩展不确定度为 %1。</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>超限</translation>
    </message>
    <message>
        <source>Control limits: %1 ± three standard uncertainties of each value.</source>
        <translation>控制限：%1 ± 各值标准不确定度的三倍。</translation>
    </message>
    <message>
        <source>Control limits: %1 ± three standard uncertainties of each value, without the part common to all values; from the observed moving range: ± %2.</source>
        <translation>控制限：%1 ± 各值标准不确定度（不含各值共有部分）的三倍；按观测到的移动极差：± %2。</translation>
    </message>
    <message>
        <source>Tolerance of the latest session: ± %1.</source>
        <translation>最近一次测量的允差：± %1。</translation>
    </message>
    <message>
        <source>± EWMA limit</source>
        <translation>± EWMA 限值</translation>
    </message>
    <message>
        <source>Each ± is an %1. All but “Δd, measured” follow from the readings alone.</source>
        <translation>各 ± 均为%1；除实测 Δd 外，均仅由读数得出。</translation>
    </message>
    <message>
        <source>instrument without a name</source>
        <translation>未命名的仪器</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Next check due</source>
        <translation>下次检查到期</translation>
    </message>
    <message>
        <source>σ horizontal</source>
        <translation>水平 σ</translation>
    </message>
    <message>
        <source>σ vertical</source>
        <translation>竖直 σ</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>overdue</source>
        <translation>已逾期</translation>
    </message>
    <message>
        <source>checked late</source>
        <translation>检查逾期</translation>
    </message>
    <message>
        <source>is missing, so this is no series: choose a file with &quot;format&quot;: &quot;alidade-series&quot;</source>
        <translation>缺失，因此这不是测量系列：请选择含 &quot;format&quot;: &quot;alidade-series&quot; 的文件</translation>
    </message>
    <message>
        <source>choose a series of sessions</source>
        <translation>请选择测量系列</translation>
    </message>
    <message>
        <source>%1 is no version of a series: it must be %2</source>
        <translation>%1 不是测量系列的版本：必须是 %2</translation>
    </message>
    <message>
        <source>add the paths of the sessions</source>
        <translation>请添加各测量记录的路径</translation>
    </message>
    <message>
        <source>each must be the path of a session in quotation marks</source>
        <translation>每一项必须是引号内的测量记录路径</translation>
    </message>
    <message>
        <source>the series names no session: add one</source>
        <translation>测量系列未列出任何测量记录：请添加</translation>
    </message>
    <message>
        <source>The day of the check %1</source>
        <translation>检查日期%1</translation>
    </message>
    <message>
        <source>The day of the next check %1</source>
        <translation>下次检查日期%1</translation>
    </message>
    <message>
        <source>The day of the next check, %1, is not after that of this check, %2: correct one of the two</source>
        <translation>下次检查日期 %1 不在本次检查日期 %2 之后：请更正其一</translation>
    </message>
    <message>
        <source>s of a direction %1</source>
        <translation>方向的 s %1</translation>
    </message>
    <message>
        <source>s of a zenith angle %1</source>
        <translation>天顶距的 s %1</translation>
    </message>
    <message>
        <source>s of a direction %1 (limit %2)</source>
        <translation>方向的 s %1（限值 %2）</translation>
    </message>
    <message>
        <source>s of a zenith angle %1 (limit %2)</source>
        <translation>天顶距的 s %1（限值 %2）</translation>
    </message>
    <message>
        <source>Stated σ: %1 of a direction, %2 of a zenith angle, both of a value observed once in both faces. χ² test of ISO 17123-3, 95 %.</source>
        <translation>给定的 σ：方向 %1，天顶距 %2，均指双盘位观测一次的值。按 ISO 17123-3 的 χ² 检验，95 %。</translation>
    </message>
    <message>
        <source>Not judged: %1</source>
        <translation>未判定：%1</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>合格：%1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>不合格：%1</translation>
    </message>
    <message>
        <source>Not judged: no round is repeated</source>
        <translation>未判定：没有重复的测回</translation>
    </message>
    <message>
        <source>State σ of a direction and of a zenith angle, as in the data sheet, for a verdict.</source>
        <translation>请按仪器数据表给出方向和天顶距的 σ，以便判定。</translation>
    </message>
    <message>
        <source>Warnings to read before the instrument is used: %1.</source>
        <translation>使用仪器前须阅读的警告：%1 条。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Checked on</source>
        <translation>检查日期</translation>
    </message>
    <message>
        <source>is not after the day of the check: correct one of the two</source>
        <translation>不在检查日期之后：请更正其一</translation>
    </message>
    <message>
        <source>A draft: the certificate says “not stated” for what is missing: %1.</source>
        <translation>草稿：证书将缺少的内容标为“未说明”：%1。</translation>
    </message>
    <message>
        <source>The laboratory did not state: %1.</source>
        <translation>实验室未说明：%1。</translation>
    </message>
    <message>
        <source>Country ZZ means “not stated”.</source>
        <translation>国家 ZZ 表示未说明。</translation>
    </message>
    <message>
        <source>Place “other” means “not stated”.</source>
        <translation>地点 “other” 表示未说明。</translation>
    </message>
    <message>
        <source>The instrument reports %1, but its vertical circle shows %2: the circle is used.</source>
        <translation>仪器报告为%1，但其竖直度盘显示为%2：以度盘为准。</translation>
    </message>
    <message>
        <source>is of %1, yet its vertical reading %2 is of the other face, so the readings were reduced: export the circles as they were read</source>
        <translation>标明为%1，但其竖直度盘读数 %2 属于另一盘位，可见读数已经过归算：请按原始读数导出度盘读数</translation>
    </message>
    <message>
        <source>face 1</source>
        <translation>盘左</translation>
    </message>
    <message>
        <source>face 2</source>
        <translation>盘右</translation>
    </message>
    <message>
        <source>point %1, round %2, %3 is already in row %4: give it another point or round, or exclude one</source>
        <translation>测点 %1、测回 %2、%3已在第 %4 行：请给它另一个测点或测回，或排除其一</translation>
    </message>
    <message>
        <source>%1 point %2 (round %3, %4)</source>
        <translation>%1 测点 %2（测回 %3、%4）</translation>
    </message>
    <message>
        <source>The verdict holds only if the tripod was not knocked %1: a knock would move Δd by ± %2 mm undetected, which U does not include</source>
        <translation>前提是三脚架%1未被碰动：碰动会使 Δd 改变 ± %2 mm 而不被发现，U 不含此项</translation>
    </message>
    <message>
        <source>Each effect has its plausible size, which these readings are too weak to show: only a trace of more than %1 σ is detectable. U of Δd, fit only, does not include these effects; U of Δd, measured, includes those in its budget.</source>
        <translation>各效应按其合理大小计，而这些读数不足以显示它们：留痕超过 %1 σ 才能检出。仅拟合 Δd 的 U 不含这些效应；实测 Δd 的 U 包含其不确定度预算所列的效应。</translation>
    </message>
    <message>
        <source>The interval from %1 to %2 mm crosses the limit of %3 mm</source>
        <translation>区间 %1 至 %2 mm 跨过限值 %3 mm</translation>
    </message>
    <message>
        <source>The interval of the fit only, from %1 to %2 mm, crosses the limit of %3 mm</source>
        <translation>仅拟合的区间 %1 至 %2 mm 跨过限值 %3 mm</translation>
    </message>
    <message>
        <source>a further jump of the orientation</source>
        <translation>另一次定向的突跳</translation>
    </message>
    <message>
        <source>The verdict holds on the condition that the tripod was not knocked %1. These readings cannot show such a knock; one of plausible size moves Δd by ± %2 mm. The probability of conformity includes a knock with its prior probability.</source>
        <translation>判定成立的条件是：三脚架%1未受碰动。这些读数无法检出此类碰动；合理大小的碰动使 Δd 改变 ± %2 mm。合格概率按碰动的先验概率将其计入。</translation>
    </message>
    <message>
        <source>The verdict depends on each of these rows alone: %1</source>
        <translation>下列各行中任一行都可单独改变判定：%1</translation>
    </message>
    <message>
        <source>On %1 readings held out of the fit, the form reduces the gap by %2 %; fitted to all readings, the form reduces the whole gap by %3 % (F test: p %4).</source>
        <translation>在未参与拟合的 %1 个留出读数上，该形式使差距缩小 %2 %；用全部读数拟合时，使全部差距缩小 %3 %（F 检验：p %4）。</translation>
    </message>
    <message>
        <source>%1 was already replaced: write both again</source>
        <extracomment>a file, one of two that belong together</extracomment>
        <translation>%1 已被替换：请将两个文件重新写入</translation>
    </message>
    <message>
        <source>%1 was already replaced, its previous content is in %2: write both again</source>
        <extracomment>a file, one of two that belong together, and the file that its old bytes are in</extracomment>
        <translation>%1 已被替换，其原内容在 %2 中：请将两个文件重新写入</translation>
    </message>
    <message>
        <source>%1 contains more than a number: leave out %2 (the unit is fixed)</source>
        <translation>%1 不只是数：请去掉 %2（单位是固定的）</translation>
    </message>
    <message>
        <source>The instrument reports an uncertain accuracy: is it levelled and at rest?</source>
        <translation>仪器不保证其精度：是否已整平且静止？</translation>
    </message>
    <message>
        <source>The instrument reports uncertain angles: is it levelled and at rest?</source>
        <translation>仪器不保证其角度：是否已整平且静止？</translation>
    </message>
    <message>
        <source>points with names are numbered; their names are in the notes</source>
        <translation>有名称的测点已编号；其名称记在备注中</translation>
    </message>
    <message>
        <source>the positions of the axis alternate in the file; a session keeps the order of readings only within each position</source>
        <translation>文件中轴位交替出现；测量记录只保留各轴位内的顺序</translation>
    </message>
    <message>
        <source>tabs separate the columns</source>
        <translation>各列以制表符分隔</translation>
    </message>
    <message>
        <source>semicolons separate the columns</source>
        <translation>各列以分号分隔</translation>
    </message>
    <message>
        <source>vertical bars separate the columns</source>
        <translation>各列以竖线分隔</translation>
    </message>
    <message>
        <source>%1 and the columns of its parts have incompatible units: name them deg, min and sec, or g, c and cc</source>
        <translation>%1 与其分、秒各列的单位不一致：请命名为 deg、min、sec 或 g、c、cc</translation>
    </message>
    <message>
        <source>%1 contains signs only: put each sign before its degrees</source>
        <translation>%1 只有正负号：请将各正负号放在其度数之前</translation>
    </message>
    <message>
        <source>has no Δd: it needs readings at 0° and at 180°</source>
        <translation>没有可报告的 Δd：需要 0° 和 180° 的读数</translation>
    </message>
    <message>
        <source>The sessions state no serial number of the device. No errors are therefore assumed to be common to them, and only larger changes are detected. Enter the number to detect smaller ones.</source>
        <translation>测量记录没有写明设备的序列号：因此认为它们没有共同的误差，只能检出较大的变化。请录入序列号，以便检出较小的变化。</translation>
    </message>
    <message>
        <source>All sessions have the same device and instrument. Their errors change Δd by the same amount each time: this amount is in U and in the mean, but not in the expected scatter.</source>
        <translation>所有测量记录均为同一设备和同一仪器：它们的误差每次对 Δd 的影响相同，因此计入 U 和均值，但不计入预期的离散。</translation>
    </message>
    <message>
        <source>The sessions were not all taken with the same instrument, or do not state its serial number: instrument errors are assumed to change Δd differently in each session.</source>
        <translation>测量记录并非全部用同一仪器测得，或未写明其序列号：认为其误差对 Δd 的影响每次不同。</translation>
    </message>
    <message>
        <source>one outlier</source>
        <translation>一个离群值</translation>
    </message>
    <message>
        <source>line %1 has no value and is skipped</source>
        <translation>第 %1 行没有值，已略去</translation>
    </message>
    <message>
        <source>the files have both %1 and %2 circles: check them separately</source>
        <translation>这些文件既有%1类又有%2类竖直度盘：请分别检查</translation>
    </message>
    <message>
        <source>lack the amplitude %1: state its plausible size</source>
        <translation>缺少幅值 %1：请给出其合理大小</translation>
    </message>
    <message>
        <source>The stated noise alone would leave residuals of %1″. Δd, measured, includes every catalogued effect, limited by these readings or by its plausible size.</source>
        <translation>仅有给定噪声时残差为 %1″。实测 Δd 包含目录中的每个效应，其大小由这些读数或其合理大小限定。</translation>
    </message>
    <message>
        <source>The model includes %1; without it, the residuals are %2 instead of %3.</source>
        <translation>模型包含%1；若不包含，残差为 %2 而不是 %3。</translation>
    </message>
    <message>
        <source>Too few draws to decide.</source>
        <translation>抽样次数太少，无法判断。</translation>
    </message>
    <message>
        <source>Draws without a result (excluded): %1.</source>
        <translation>没有结果而略去的抽样：%1。</translation>
    </message>
    <message>
        <source>The offset Δz of the arc&apos;s centre from the axis, perpendicular to the plane of the arc, was not measured.</source>
        <translation>圆心相对回转轴在垂直于圆弧平面方向上的偏移量 Δz 未经测量。</translation>
    </message>
    <message>
        <source>The journal is broken from entry %1 on: this entry or an earlier one was changed outside this program.</source>
        <translation>更改日志从第 %1 条起不再连贯：该条或更早的一条曾在本程序之外被更改。</translation>
    </message>
    <message>
        <source>According to %1, %2 is %3; these readings give %4: the known size is out of date with a probability of %5.</source>
        <translation>据%1，%2为 %3；这些读数给出 %4：该已知值已过时的概率为 %5。</translation>
    </message>
    <message>
        <source>Measure with instrument %1 in %2 more sessions: %3 would then be detectable at %4 σ.</source>
        <translation>再用仪器 %1 测量，还需 %2 份测量记录：届时能以 %4 σ 的程度显示%3。</translation>
    </message>
    <message>
        <source>Measure guideway %1 in %2 more sessions: %3 would then be detectable at %4 σ.</source>
        <translation>再次测量导轨 %1，还需 %2 份测量记录：届时能以 %4 σ 的程度显示%3。</translation>
    </message>
    <message>
        <source>The compensator&apos;s tilts in the two faces contradict each other by %1″; they are not used.</source>
        <translation>补偿器在两个盘位的倾斜量相差 %1″，相互矛盾；不予采用。</translation>
    </message>
    <message>
        <source>%1: the pointing zero moved by %2 horizontally and %3 vertically (1σ) while the position was read; U assumes that the zeros scatter %4 times their stated σ.</source>
        <translation>%1：读取该轴位期间，瞄准零位水平移动 %2，竖直移动 %3（1σ）；U 按零位离散为给定值的 %4 倍计算。</translation>
    </message>
    <message>
        <source>The tolerance applies to the whole distance from the axis, and its part perpendicular to the plane of the arc was not measured: read both positions over more of the arc, or state the known plane offset of the device. %1</source>
        <translation>允差针对到回转轴的整个距离，而圆心在垂直于圆弧平面方向上的偏离未经测量：请在更长的弧段上读取两个轴位，或给出设备的平面偏移已知值。%1</translation>
    </message>
    <message>
        <source>%1, indistinguishable here from %2</source>
        <extracomment>causes, and what looks like them</extracomment>
        <translation>%1（在此无法与%2区分）</translation>
    </message>
    <message>
        <source>Model and readings disagree; accepted only if the cause is %1</source>
        <translation>模型与读数不符；仅当原因为%1时合格</translation>
    </message>
    <message>
        <source>Model and readings disagree; rejected only if the cause is %1</source>
        <translation>模型与读数不符；仅当原因为%1时不合格</translation>
    </message>
    <message>
        <source>Undetectable here and not in U, yet a plausible size moves Δd by more than U: %1</source>
        <translation>在此无法检出，也不在 U 之内，但其合理大小使 Δd 的改变超过 U：%1</translation>
    </message>
    <message>
        <source>%1 different from its known value</source>
        <extracomment>a known size of an effect that the readings contradict: &quot;trunnion tilt different from its known value&quot;</extracomment>
        <translation>与已知值不同的%1</translation>
    </message>
    <message>
        <source>sightings</source>
        <translation>照准次数</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>would show %1</source>
        <translation>可显示%1</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1与%2</translation>
    </message>
    <message>
        <source>separates %1</source>
        <translation>可区分%1</translation>
    </message>
    <message>
        <source>%1 known</source>
        <translation>已知%1</translation>
    </message>
    <message>
        <source>min, about</source>
        <translation>约需分钟</translation>
    </message>
    <message>
        <source>Typical U for this plan: %1 mm.</source>
        <translation>此读数计划的典型 U：%1 mm。</translation>
    </message>
    <message>
        <source>What would reduce U further</source>
        <translation>还可用什么减小 U</translation>
    </message>
    <message>
        <source>Undecided, whatever U is: model and readings disagree, and no catalogued effect explains it</source>
        <translation>无论 U 多大均待定：模型与读数不符，且目录中没有效应能够解释</translation>
    </message>
    <message>
        <source>%1 (signs: %2)</source>
        <extracomment>a sentence, and the signs of what it says</extracomment>
        <translation>%1（迹象：%2）</translation>
    </message>
    <message>
        <source>%1, and noise larger than stated</source>
        <translation>%1，另有大于给定的噪声</translation>
    </message>
    <message>
        <source>alone</source>
        <translation>仅此一项</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>并有%1</translation>
    </message>
    <message>
        <source>Enough: two causes are identified, %1 and %2.</source>
        <translation>已足够：已判明两个原因，%1和%2。</translation>
    </message>
    <message>
        <source>Two causes are identified, %1 and %2, but Δd needs readings at both positions.</source>
        <translation>已判明两个原因，%1和%2，但 Δd 需要两个轴位的读数。</translation>
    </message>
    <message>
        <source>The cause is identified, %1, but Δd needs readings at both positions.</source>
        <translation>原因已判明，为%1，但 Δd 需要两个轴位的读数。</translation>
    </message>
    <message>
        <source>The faces differ by more than 2° (different targets, or misread): %1.</source>
        <translation>两个盘位相差超过 2°（不是同一目标，或误读）：%1。</translation>
    </message>
    <message>
        <source>%1 is most informative per minute (it takes %2 min): it shows whether %3 is also present.</source>
        <translation>按每分钟的信息量，%1 最佳（需 %2 min）：可显示是否还有%3。</translation>
    </message>
    <message>
        <source>an uncatalogued effect</source>
        <translation>目录之外的效应</translation>
    </message>
    <message>
        <source>Enough: the cause is identified, %1; the Bayes factor for a cause is %2 to 1.</source>
        <translation>已足够：原因已判明，为%1；有原因相对“无原因”的贝叶斯因子为 %2 : 1。</translation>
    </message>
    <message>
        <source>Enough: the same cause occurs twice, %1.</source>
        <translation>已足够：同一原因出现两次，%1。</translation>
    </message>
    <message>
        <source>Enough: there is %1; the diagnosis finds its form.</source>
        <translation>已足够：存在%1；诊断将求出其形式。</translation>
    </message>
    <message>
        <source>There is %1, but Δd needs readings at both positions.</source>
        <translation>存在%1，但 Δd 需要两个轴位的读数。</translation>
    </message>
    <message>
        <source>Enough: the cause is identified, %1; these sightings cannot show a further one.</source>
        <translation>已足够：原因已判明，为%1；这些照准不能显示是否另有原因。</translation>
    </message>
    <message>
        <source>Not enough yet: %1 is identified, but the readings do not exclude a further cause.</source>
        <translation>尚不足够：%1 已判明，但读数不能排除另有原因。</translation>
    </message>
    <message>
        <source>Not enough yet: %1 is evident and a further cause is present, but none is probable enough to be identified.</source>
        <translation>尚不足够：%1 已有明证，且还存在另一原因，但没有哪个原因的概率足以确认。</translation>
    </message>
    <message>
        <source>Not enough yet: %1 is evident; further readings show whether it is the only cause.</source>
        <translation>尚不足够：%1 已有明证；进一步的读数将显示它是否为唯一原因。</translation>
    </message>
    <message>
        <source>Not looked for, because this protocol cannot show these effects: %1.</source>
        <translation>未作查找的效应（本测量方案无法显现）：%1。</translation>
    </message>
    <message>
        <source>Enough for a verdict: whatever effect is present, Δd is within the tolerance.</source>
        <translation>已足以判定：无论存在何种效应，Δd 都在允差之内。</translation>
    </message>
    <message>
        <source>Enough for a verdict: whatever effect is present, Δd is beyond the tolerance.</source>
        <translation>已足以判定：无论存在何种效应，Δd 都超出允差。</translation>
    </message>
    <message>
        <source>More of these sightings will not help: none separates causes or reduces U.</source>
        <translation>继续这样照准已无帮助：既不能区分各种原因，也不能减小 U。</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>point numbers and their face: &quot;4, 9 in face 2&quot;</extracomment>
        <translation>%2 %1</translation>
    </message>
    <message>
        <source>%1; %2 in %3</source>
        <translation>%1；%3 %2</translation>
    </message>
    <message>
        <source>Where the gap lies</source>
        <translation>差距所在</translation>
    </message>
    <message>
        <source>%1, changing between sessions</source>
        <translation>%1，各测量记录间变化</translation>
    </message>
    <message>
        <source>What the sessions share</source>
        <translation>测量记录共有的效应</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>所属</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>In one session (σ)</source>
        <translation>单份测量记录中（σ）</translation>
    </message>
    <message>
        <source>In all (σ)</source>
        <translation>全部测量记录中（σ）</translation>
    </message>
    <message>
        <source>with what is shared</source>
        <translation>计入共有的效应</translation>
    </message>
    <message>
        <source>The residuals of sessions held out of the fit shrink by %1 %.</source>
        <translation>留在拟合之外的测量记录，其残差缩小 %1 %。</translation>
    </message>
    <message>
        <source>Each session alone and within the series</source>
        <translation>各测量记录单独及结合系列的诊断</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Alone</source>
        <translation>单独</translation>
    </message>
    <message>
        <source>Within the series</source>
        <translation>结合系列</translation>
    </message>
    <message>
        <source>Undetectable in all sessions together</source>
        <translation>全部测量记录合在一起也检测不出的效应</translation>
    </message>
    <message>
        <source>belongs to</source>
        <translation>归属</translation>
    </message>
    <message>
        <source>axis at</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>in time</source>
        <translation>时间上</translation>
    </message>
    <message>
        <source>shows in</source>
        <translation>显示于</translation>
    </message>
    <message>
        <source>along the arc</source>
        <translation>沿弧</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>度盘</translation>
    </message>
    <message>
        <source>session</source>
        <translation>测量记录</translation>
    </message>
    <message>
        <source>guideway</source>
        <translation>导轨</translation>
    </message>
    <message>
        <source>guideway or instrument</source>
        <translation>导轨或仪器</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>the radii</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>the centres</source>
        <translation>圆心</translation>
    </message>
    <message>
        <source>positions at one axis angle</source>
        <translation>同一轴位的各次测量</translation>
    </message>
    <message>
        <source>the pointing zeros</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>the residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>1st quarter</source>
        <translation>第 1 个四分之一时段</translation>
    </message>
    <message>
        <source>2nd quarter</source>
        <translation>第 2 个四分之一时段</translation>
    </message>
    <message>
        <source>3rd quarter</source>
        <translation>第 3 个四分之一时段</translation>
    </message>
    <message>
        <source>4th quarter</source>
        <translation>第 4 个四分之一时段</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>must be a whole number of sessions, 0 to 1 000 000</source>
        <translation>必须是测量记录的份数：0 至 1 000 000 的整数</translation>
    </message>
    <message>
        <source>%1 min is out of range: turning the axis, plunging or driving the slider takes 0 to 1000 min</source>
        <translation>%1 min 超出范围：转动轴、倒镜或移动滑块的用时为 0 至 1000 min</translation>
    </message>
    <message>
        <source>The model holds where %1 is within %2: the form displaces readings there by less than their σ.</source>
        <translation>%1 在 %2 之内时模型成立：此处该形式使读数的偏移小于其 σ。</translation>
    </message>
    <message>
        <source>For every reading, state which corrections were on; type “none” if all were off.</source>
        <translation>请为每个读数注明打开了哪些改正；若全部关闭，请输入 none。</translation>
    </message>
    <message>
        <source>The verdict covers only the plane of the arc; perpendicular to it, the arc&apos;s centre is %1 from the axis.</source>
        <translation>仅评定圆弧平面内的量：在垂直于该平面的方向上，圆心距回转轴 %1。</translation>
    </message>
    <message>
        <source>the pointing zero at %1 after the readings, in face %2, is the mean of %3</source>
        <translation>%1 的瞄准零位（读数之后，盘位 %2）为%3的平均值</translation>
    </message>
    <message>
        <source>the pointing zero at %1, in face %2, is the mean of %3</source>
        <translation>%1 的瞄准零位（盘位 %2）为%3的平均值</translation>
    </message>
    <message>
        <source>the pointing zero at %1 was sighted in face 2 only (%2) and is converted to face 1: collimation and index error count as errors of the zero</source>
        <translation>%1 的瞄准零位仅以盘右照准（%2），已换算到盘左：视准轴误差和指标差按零位误差计入</translation>
    </message>
    <message>
        <source>no sighting is named %1: state the name of the pointing zero as in the file</source>
        <translation>没有名为 %1 的照准：请按文件中的写法给出瞄准零位的名称</translation>
    </message>
    <message>
        <source>the column %1 holds expanded uncertainties: each is divided by %2 to give the standard uncertainty</source>
        <translation>列 %1 为扩展不确定度：各值除以 %2 得到标准不确定度</translation>
    </message>
    <message>
        <source>the column %1 is read as standard uncertainties (k = 1): halve the values if they are expanded</source>
        <translation>列 %1 按标准不确定度（k = 1）处理：若为扩展不确定度，请减半</translation>
    </message>
    <message>
        <source>So are those of the pointing zeros; the distance contributes with its stated σ.</source>
        <translation>瞄准零位的分量同样放大；距离按给定的 σ 计入。</translation>
    </message>
    <message>
        <source>Those of the pointing zeros are %1 times their stated σ, because the sightings of the zeros scatter so much; the distance contributes with its stated σ.</source>
        <translation>瞄准零位的分量为其给定 σ 的 %1 倍，因为零位照准的离散如此之大；距离按给定的 σ 计入。</translation>
    </message>
    <message>
        <source>Pointing zeros and distance contribute with their stated σ.</source>
        <translation>瞄准零位和距离按给定的 σ 计入。</translation>
    </message>
    <message>
        <source>Contributions of the readings are based on the stated noise.</source>
        <translation>来自读数的分量基于给定噪声。</translation>
    </message>
    <message>
        <source>Contributions of the readings are scaled by their scatter, %1 times the stated noise.</source>
        <translation>来自读数的分量按其离散放大，为给定噪声的 %1 倍。</translation>
    </message>
    <message>
        <source>Some sessions have an elevation circle, others a zenith circle: all sizes of errors of the vertical circle are those on a zenith circle.</source>
        <translation>部分测量记录为高度角度盘，其余为天顶距度盘：所有竖直度盘误差的大小均按天顶距度盘给出。</translation>
    </message>
    <message>
        <source>Sum of the redundancies of its readings; unknowns of several arcs count in part</source>
        <translation>该圆弧各读数多余观测分量之和；几条圆弧共有的未知数按比例计入</translation>
    </message>
    <message>
        <source>%1: while the position was read, the pointing zero changed in face 2 by %2 horizontally and %3 vertically more than in face 1 (1σ): one of these sightings may be misread; U assumes that the zeros scatter %4 times their stated σ.</source>
        <translation>%1：读取该轴位期间，瞄准零位在盘右的变化比盘左水平多 %2，竖直多 %3（1σ）：其中一次照准可能误读；U 按零位离散为给定值的 %4 倍计算。</translation>
    </message>
    <message>
        <source>Check the entries of the pointing zero, or sight it again in both faces.</source>
        <translation>请检查瞄准零位的输入，或用两个盘位重新照准。</translation>
    </message>
    <message>
        <source>a file is of the instrument with the serial number %1; the session keeps %2</source>
        <translation>有一个文件属于序列号为 %1 的仪器；测量记录保留 %2</translation>
    </message>
    <message>
        <source>%1: the values scatter about one mean as their uncertainties say.</source>
        <translation>%1：各值围绕同一平均值的离散与其不确定度相符。</translation>
    </message>
    <message>
        <source>The values of %1 and %2 differ by %3: measure on a third date to tell a change from understated uncertainties.</source>
        <translation>%1 与 %2 的值相差 %3：请在第三个日期测量，以区分变化与被低估的不确定度。</translation>
    </message>
    <message>
        <source>All values are of one date: measure on other dates to tell a change from understated uncertainties.</source>
        <translation>所有值都属于同一日期：请在其他日期测量，以区分变化与被低估的不确定度。</translation>
    </message>
    <message>
        <source>%1 states %2 in the unit %3, not in %4: the value is left out until it is converted.</source>
        <translation>%1 中%2的单位是 %3，而不是 %4：换算之前不使用该值。</translation>
    </message>
    <message>
        <source>each of the columns %1 could hold the value: name only one of them “value” in the first line</source>
        <translation>列 %1 中的每一列都可能是值：请在首行只将其中一列命名为“value”</translation>
    </message>
    <message>
        <source>each of the columns %1 could hold the standard uncertainty: name only one of them “u” in the first line</source>
        <translation>列 %1 中的每一列都可能是标准不确定度：请在首行只将其中一列命名为“u”</translation>
    </message>
    <message>
        <source>the columns %1 and %2 state different units: give the value and its uncertainty in one unit</source>
        <translation>列 %1 和 %2 注明的单位不同：请用同一单位给出值及其不确定度</translation>
    </message>
    <message>
        <source>has the readings of %1 once more: leave one of the two out</source>
        <translation>与 %1 的读数完全相同：请去掉其中一个</translation>
    </message>
    <message>
        <source>is of the instrument with the serial number %1, an earlier file of that with %2: check each instrument by itself</source>
        <translation>属于序列号为 %1 的仪器，而前面的文件属于 %2：请分别检验每台仪器</translation>
    </message>
    <message>
        <source>measured on %1; the check takes the day of an earlier file, %2</source>
        <translation>测量日期为 %1；检验采用前面文件的日期 %2</translation>
    </message>
    <message>
        <source>the slider readings decrease where the slider coordinate s increases (at 0° with the arc angle, at 180° against it): enter them with the opposite sign, or leave them out</source>
        <translation>滑块坐标 s 增大处滑块读数减小（0° 时 s 与弧角同向，180° 时反向）：请将读数改为相反符号，或不输入</translation>
    </message>
    <message>
        <source>its own in each session</source>
        <translation>各测量记录各有其值</translation>
    </message>
    <message>
        <source>the instrument of each session</source>
        <translation>各测量记录的仪器</translation>
    </message>
    <message>
        <source>the guideway of each session</source>
        <translation>各测量记录的导轨</translation>
    </message>
    <message>
        <source>Measure %1 more sessions: %2 would then be detectable at %3 σ.</source>
        <translation>还需测量 %1 份测量记录：届时能以 %3 σ 的程度显示%2。</translation>
    </message>
    <message>
        <source>The fitted radius differs from the nominal radius of %1 mm by %2 mm; the readings and the σ of R0 and L allow at most %3 mm at 0.1 % risk.</source>
        <translation>拟合半径与标称半径 %1 mm 相差 %2 mm；按读数以及 R0 和 L 的 σ，在 0.1 % 的风险下最多容许 %3 mm。</translation>
    </message>
    <message>
        <source>Check R0, its σ and the distance: the diagnosis seeks causes of this difference.</source>
        <translation>请检查 R0、其 σ 和距离：诊断会为这一差值寻找原因。</translation>
    </message>
    <message>
        <source>%1 has the same readings as %2: a copy counts as a measurement of its own, and makes U too small.</source>
        <translation>%1 与 %2 的读数相同：副本会被当作一次独立测量，使 U 偏小。</translation>
    </message>
    <message>
        <source>Delete the copied position, or type the readings taken there.</source>
        <translation>请删除复制的轴位，或输入在该处实际读取的读数。</translation>
    </message>
    <message>
        <source>the tolerance of %1 mm</source>
        <translation>允差 %1 mm</translation>
    </message>
    <message>
        <source>Take more readings, or measure what the diagnosis advises.</source>
        <translation>请增加读数，或按诊断的建议测量。</translation>
    </message>
    <message>
        <source>degrees, minutes and seconds stand in columns of their own; copy a row with their names, too, or import the table</source>
        <translation>度、分、秒各占一列；请连同列名所在的行一起复制，或导入该表格</translation>
    </message>
</context>
<context>
    <name>PlaceText</name>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>row %1 (point %2)</source>
        <translation>第 %1 行（测点 %2）</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>model effects</source>
        <translation>模型效应</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>formula of own effect %1</source>
        <translation>自定义效应 %1 的公式</translation>
    </message>
    <message>
        <source>plausible sizes of own effect %1</source>
        <translation>自定义效应 %1 的合理大小</translation>
    </message>
    <message>
        <source>own effect %1</source>
        <translation>自定义效应 %1</translation>
    </message>
    <message>
        <source>own effects</source>
        <translation>自定义效应</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>a place and its problem, as a predicate (&quot;is empty&quot;) and as a sentence</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>known value of the device</source>
        <translation>设备的已知值</translation>
    </message>
    <message>
        <source>known value of the instrument</source>
        <translation>仪器的已知值</translation>
    </message>
</context>
<context>
    <name>PositionText</name>
    <message>
        <source>Axis at %1, point %2, round %3, %4</source>
        <translation>轴位 %1、测点 %2、测回 %3、%4</translation>
    </message>
</context>
<context>
    <name>Proposal</name>
    <message>
        <source> and </source>
        <translation>和</translation>
    </message>
</context>
<context>
    <name>ReadingColumn</name>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation>滑块位置的编号</translation>
    </message>
    <message>
        <source>point number</source>
        <translation>测点编号</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Round of readings; empty means 1</source>
        <translation>读数的测回；空表示 1</translation>
    </message>
    <message>
        <source>round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>&amp;Round Column</source>
        <translation>测回列(&amp;R)</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>Face of the theodolite, 1 or 2; empty means 1</source>
        <translation>经纬仪的盘位：1 为盘左，2 为盘右；空表示 1</translation>
    </message>
    <message>
        <source>face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>&amp;Face Column</source>
        <translation>盘位列(&amp;F)</translation>
    </message>
    <message>
        <source>Horizontal α</source>
        <translation>水平 α</translation>
    </message>
    <message>
        <source>Reading of the horizontal circle, degrees minutes seconds; 3415224 is 341°52′24″</source>
        <translation>水平度盘读数，度分秒；3415224 即 341°52′24″</translation>
    </message>
    <message>
        <source>horizontal reading</source>
        <translation>水平读数</translation>
    </message>
    <message>
        <source>Zenith β</source>
        <translation>天顶距 β</translation>
    </message>
    <message>
        <source>Reading of the vertical circle, degrees minutes seconds</source>
        <translation>竖直度盘读数，度分秒</translation>
    </message>
    <message>
        <source>vertical reading</source>
        <translation>竖直读数</translation>
    </message>
    <message>
        <source>Slider s</source>
        <translation>滑块 s</translation>
    </message>
    <message>
        <source>Slider coordinate at this sighting, degrees minutes seconds</source>
        <translation>本次照准时的滑块坐标，度分秒</translation>
    </message>
    <message>
        <source>slider reading</source>
        <translation>滑块读数</translation>
    </message>
    <message>
        <source>&amp;Slider Column</source>
        <translation>滑块列(&amp;S)</translation>
    </message>
    <message>
        <source>vα ″</source>
        <translation>vα ″</translation>
    </message>
    <message>
        <source>Residual of the horizontal reading in arcseconds: observed − adjusted, right positive</source>
        <translation>水平读数的残差，单位角秒：观测值 − 平差值，向右为正</translation>
    </message>
    <message>
        <source>vβ ″</source>
        <translation>vβ ″</translation>
    </message>
    <message>
        <source>Residual of the vertical reading in arcseconds: observed − adjusted, up positive</source>
        <translation>竖直读数的残差，单位角秒：观测值 − 平差值，向上为正</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Free text</source>
        <translation>自由文本</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Horizontal
as read</source>
        <translation>水平
读数</translation>
    </message>
    <message>
        <source>Vertical
as read</source>
        <translation>竖直
读数</translation>
    </message>
    <message>
        <source>Tilt ⟂ ″</source>
        <translation>倾斜 ⟂ ″</translation>
    </message>
    <message>
        <source>Tilt that the compensator read across the line of sight, in arcseconds; positive if the axis leans right</source>
        <translation>补偿器在垂直于视线方向的读数，单位角秒；竖轴向右倾为正</translation>
    </message>
    <message>
        <source>cross tilt</source>
        <translation>横向倾斜</translation>
    </message>
    <message>
        <source>Cross Tilt Column</source>
        <translation>横向倾斜列</translation>
    </message>
    <message>
        <source>Tilt ∥ ″</source>
        <translation>倾斜 ∥ ″</translation>
    </message>
    <message>
        <source>Tilt that the compensator read along the line of sight, in arcseconds; positive if the axis leans forward</source>
        <translation>补偿器在视线方向的读数，单位角秒；竖轴向前倾为正</translation>
    </message>
    <message>
        <source>length tilt</source>
        <translation>纵向倾斜</translation>
    </message>
    <message>
        <source>Length Tilt Column</source>
        <translation>纵向倾斜列</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>改正</translation>
    </message>
    <message>
        <source>corrections</source>
        <translation>改正</translation>
    </message>
    <message>
        <source>Corrections Column</source>
        <translation>改正列</translation>
    </message>
    <message>
        <source>Taken at</source>
        <translation>读取时间</translation>
    </message>
    <message>
        <source>When the instrument sent the reading, with the time zone</source>
        <translation>仪器发送该读数的时间，含时区</translation>
    </message>
    <message>
        <source>time of the reading</source>
        <translation>读数时间</translation>
    </message>
    <message>
        <source>Time Column</source>
        <translation>时间列</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>返回码</translation>
    </message>
    <message>
        <source>GeoCOM return code of the angles; 0: the instrument confirms them</source>
        <translation>随角度返回的 GeoCOM 返回码；0：仪器保证该读数</translation>
    </message>
    <message>
        <source>return code</source>
        <translation>返回码</translation>
    </message>
    <message>
        <source>Return Code Column</source>
        <translation>返回码列</translation>
    </message>
    <message>
        <source>Serial No.</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Serial number of the instrument that sent the reading</source>
        <translation>发送该读数的仪器的序列号</translation>
    </message>
    <message>
        <source>instrument serial number</source>
        <translation>仪器序列号</translation>
    </message>
    <message>
        <source>Serial Number Column</source>
        <translation>序列号列</translation>
    </message>
    <message>
        <source>Rows without a tick are kept but excluded from the fit</source>
        <translation>未勾选的行保留，但不参与拟合</translation>
    </message>
    <message>
        <source>Corrections that the instrument applied. Type inclination (compensator), standing_axis (vertical axis), collimation, tilting_axis (trunnion axis) or none; leave the cell empty if they are unknown</source>
        <translation>仪器已施加的改正。请输入 inclination（补偿器倾斜）、standing_axis（竖轴）、collimation（照准差）、tilting_axis（横轴）或 none（均未施加）；未知则留空</translation>
    </message>
</context>
<context>
    <name>ReadingDoubts</name>
    <message>
        <source>The previous readings belong to %1, this reading to %2: has the axis been turned?</source>
        <translation>此前的读数属于 %1，本读数属于 %2：轴是否已转动？</translation>
    </message>
    <message>
        <source>The session&apos;s instrument has serial number %1, but this reading comes from serial number %2.</source>
        <translation>测量记录所填仪器的序列号为 %1，而本读数来自序列号 %2。</translation>
    </message>
    <message>
        <source>The previous readings come from the instrument with serial number %1, but this one from serial number %2.</source>
        <translation>此前的读数来自序列号为 %1 的仪器，而本读数来自序列号 %2。</translation>
    </message>
    <message>
        <source>%1 (Return code %2.)</source>
        <translation>%1（返回码 %2。）</translation>
    </message>
    <message>
        <source>The compensator is off: the readings contain the tilt of the instrument.</source>
        <translation>补偿器已关闭：读数含有仪器的倾斜。</translation>
    </message>
    <message>
        <source>The instrument corrected “%1” before and corrects “%2” now.</source>
        <extracomment>words such as &quot;inclination collimation&quot;, or &quot;none&quot;</extracomment>
        <translation>仪器此前改正“%1”，现在改正“%2”。</translation>
    </message>
    <message>
        <source>The same angles are already at %1 (%2): did the instrument send them again?</source>
        <extracomment>a position of the axis and a sighting there: &quot;0°&quot; and &quot;Point 3&quot;</extracomment>
        <translation>相同的角度已在 %1（%2）：仪器是否重发？</translation>
    </message>
    <message>
        <source>The same angles came before: did the instrument send them again?</source>
        <translation>相同的角度此前已到来：仪器是否重发？</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>%1 is already entered there and would be replaced.</source>
        <translation>该处已有 %1，将被替换。</translation>
    </message>
    <message>
        <source>The %1 is already entered (%2) and would be replaced.</source>
        <translation>%1已录入（%2），将被替换。</translation>
    </message>
    <message>
        <source>About %1 and %2 were expected: is it the right target?</source>
        <translation>预期约为 %1 和 %2：目标是否正确？</translation>
    </message>
    <message>
        <source>The instrument points at the pointing zero: is it the right target?</source>
        <translation>仪器照准了瞄准零位：目标是否正确？</translation>
    </message>
    <message>
        <source>The pointing zero of %1 is %2 and %3: is it the right target?</source>
        <translation>%1 的瞄准零位为 %2 和 %3：目标是否正确？</translation>
    </message>
    <message>
        <source>A reading came, %1 and %2, but the session lacks the position that the protocol asks for. Add the position, then take the reading.</source>
        <translation>读数 %1 和 %2 已到来，而测量记录中没有方案要求的轴位。请添加该轴位，然后采用该读数。</translation>
    </message>
    <message>
        <source>A reading came, %1 and %2, but all readings are already taken. Add a row, or choose a row to be read again, then take the reading.</source>
        <translation>读数 %1 和 %2 已到来，而所有读数均已读取。请添加一行，或选择要重读的一行，然后采用该读数。</translation>
    </message>
    <message>
        <source>%1: %2 and %3 in %4 were read.</source>
        <extracomment>where a reading would go, and what was read: &quot;0°: point 3&quot;, two angles and a face</extracomment>
        <translation>%1：读到 %2 和 %3，%4。</translation>
    </message>
    <message>
        <source>The vertical circle shows %1, but %2 is asked for.</source>
        <translation>竖直度盘显示为%1，而要求的是%2。</translation>
    </message>
    <message>
        <source>The instrument points at the pointing zero: if accepted, the reading becomes the %1.</source>
        <translation>仪器照准了瞄准零位：若采用，该读数即为%1。</translation>
    </message>
</context>
<context>
    <name>ReadingLanding</name>
    <message>
        <source>Take pointing zero from the instrument</source>
        <translation>从仪器读取瞄准零位</translation>
    </message>
    <message>
        <source>Take point %1 from the instrument</source>
        <translation>从仪器读取测点 %1</translation>
    </message>
</context>
<context>
    <name>ReadingsEditor</name>
    <message>
        <source>Add point %1</source>
        <translation>添加测点 %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Change %1 of point %2</source>
        <translation>更改测点 %2 的%1</translation>
    </message>
    <message>
        <source>Insert reading</source>
        <translation>插入读数</translation>
    </message>
    <message>
        <source>Add %1 rows</source>
        <translation>添加 %1 行</translation>
    </message>
    <message>
        <source>Delete reading</source>
        <translation>删除读数</translation>
    </message>
    <message>
        <source>Delete %1 readings</source>
        <translation>删除 %1 个读数</translation>
    </message>
    <message>
        <source>Exclude reading</source>
        <translation>排除读数</translation>
    </message>
    <message>
        <source>Use reading</source>
        <translation>使用读数</translation>
    </message>
    <message>
        <source>Exclude %1 readings</source>
        <translation>排除 %1 个读数</translation>
    </message>
    <message>
        <source>Use %1 readings</source>
        <translation>使用 %1 个读数</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Paste %1 readings</source>
        <translation>粘贴 %1 个读数</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>State why excluded</source>
        <translation>说明排除原因</translation>
    </message>
</context>
<context>
    <name>RemovePosition</name>
    <message>
        <source>Delete position %1</source>
        <translation>删除轴位 %1</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>untitled session</source>
        <translation>未命名测量记录</translation>
    </message>
    <message>
        <source>unsaved changes: SHA-256 of the session&apos;s content %1</source>
        <translation>未保存的更改：测量记录内容的 SHA-256 %1</translation>
    </message>
    <message>
        <source>Alidade %1 · Acceptance report</source>
        <translation>Alidade %1 · 验收报告</translation>
    </message>
    <message>
        <source>Alidade %1 · Acceptance report · No. %2</source>
        <translation>Alidade %1 · 验收报告 · 编号 %2</translation>
    </message>
    <message>
        <source>session not saved to a file</source>
        <translation>测量记录未保存到文件</translation>
    </message>
    <message>
        <source>The session of this report, to be opened with Alidade</source>
        <translation>本报告的测量记录，可用 Alidade 打开</translation>
    </message>
    <message>
        <source>The results of this report, to be read by programs</source>
        <translation>本报告的结果，供程序读取</translation>
    </message>
    <message>
        <source>%1 cannot be written: painting failed</source>
        <translation>%1 无法写入：绘制失败</translation>
    </message>
    <message>
        <source>Acceptance report: %1</source>
        <translation>验收报告：%1</translation>
    </message>
    <message>
        <source>The PDF cannot be read (the session attached to it is missing)</source>
        <translation>无法读取该 PDF（所附测量记录缺失）</translation>
    </message>
    <message>
        <source>The PDF cannot be read (the session attached to it is damaged)</source>
        <translation>无法读取该 PDF（所附测量记录已损坏）</translation>
    </message>
    <message>
        <source>No session is attached to this PDF: a report of Alidade contains its session unless the session was left out</source>
        <translation>该 PDF 未附测量记录：Alidade 的报告含有其测量记录，除非被略去</translation>
    </message>
    <message>
        <source>The PDF cannot be read (%1)</source>
        <translation>无法读取该 PDF（%1）</translation>
    </message>
    <message>
        <source>%1 (stated)</source>
        <extracomment>a standard uncertainty, as stated in the session or as the program assumes it</extracomment>
        <translation>%1（给定）</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1（默认）</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>horizontal %1, vertical %2</source>
        <translation>水平 %1，竖直 %2</translation>
    </message>
    <message>
        <source>%1, taken as exact (default)</source>
        <translation>%1，视为精确（默认）</translation>
    </message>
    <message>
        <source>%1, σ %2 mm (stated)</source>
        <translation>%1，σ %2 mm（给定）</translation>
    </message>
    <message>
        <source>zenith</source>
        <extracomment>what the vertical circle reads: zenith angles</extracomment>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>elevation</source>
        <extracomment>what the vertical circle reads: elevation angles</extracomment>
        <translation>高度角</translation>
    </message>
    <message>
        <source>%1, planar relation</source>
        <translation>%1，平面关系式</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>实验室</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>客户</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>地点</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>测量日期</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>报告日期</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Circles traceable</source>
        <translation>度盘溯源</translation>
    </message>
    <message>
        <source>σ of the circles</source>
        <translation>度盘 σ</translation>
    </message>
    <message>
        <source>σ pointing zero</source>
        <translation>瞄准零位 σ</translation>
    </message>
    <message>
        <source>that of the circles</source>
        <extracomment>a standard uncertainty: as that of the circles</extracomment>
        <translation>同度盘</translation>
    </message>
    <message>
        <source>σ of the slider</source>
        <translation>滑块 σ</translation>
    </message>
    <message>
        <source>Distance L</source>
        <translation>距离 L</translation>
    </message>
    <message>
        <source>L measured</source>
        <translation>L 的测量</translation>
    </message>
    <message>
        <source>Nominal radius R0</source>
        <translation>标称半径 R0</translation>
    </message>
    <message>
        <source>Vertical circle</source>
        <translation>竖直度盘</translation>
    </message>
    <message>
        <source>Gap between model and readings</source>
        <translation>模型与读数的差距</translation>
    </message>
    <message>
        <source>%1.</source>
        <extracomment>a headline as a sentence
----------
a clause as a sentence</extracomment>
        <translation>%1。</translation>
    </message>
    <message>
        <source>Unless marked “measured”, the figures of this report are those of the session&apos;s model; the diagnosis neither added nor removed anything. The verdict holds only if both results, measured and fit only, agree.</source>
        <translation>除注明“实测”者外，本报告的数字均按测量记录的模型得出；没有因诊断而增加或略去任何内容。只有实测与仅拟合的结果一致时，判定才成立。</translation>
    </message>
    <message>
        <source>the logo “%1” cannot be used: there is no such file</source>
        <translation>徽标“%1”无法使用：没有这个文件</translation>
    </message>
    <message>
        <source>the logo “%1” cannot be used: %2</source>
        <translation>徽标“%1”无法使用：%2</translation>
    </message>
    <message>
        <source>Ringed: a position measured again.</source>
        <translation>带圈：复测的轴位。</translation>
    </message>
    <message>
        <source>Struck through: face 2.</source>
        <translation>带划线：盘右。</translation>
    </message>
    <message>
        <source>Grey: permitted places of the centres, tolerance ± %1 mm.</source>
        <translation>灰色：允差 ± %1 mm 时圆心可在的范围。</translation>
    </message>
    <message>
        <source>Δx leads from O2 to the cross, where O2 would be if the positions agreed; without a cross, they agree.</source>
        <translation>Δx 由 O2 指向十字，即各轴位闭合时 O2 应在之处；没有十字则已闭合。</translation>
    </message>
    <message>
        <source>Figure 1. Sighted points in the arc plane; no arc was fitted.</source>
        <translation>图 1：圆弧平面内的照准点；没有拟合出圆弧。</translation>
    </message>
    <message>
        <source>Figure 1. Fitted arcs and sighted points in true proportion, frame at the theodolite, x right, y up. Filled points and full line: axis at 0°; hollow points and broken line: 180°.</source>
        <translation>图 1：拟合圆弧和照准点，按真实比例，坐标系在经纬仪处，x 向右，y 向上。实心点和实线：轴在 0°；空心点和虚线：180°。</translation>
    </message>
    <message>
        <source>The strokes are the residuals, from the adjusted point on the arc, enlarged %1.</source>
        <extracomment>%1: how many times as long, &quot;× 500&quot;</extracomment>
        <translation>短线为残差，自圆弧上的平差点起，放大 %1。</translation>
    </message>
    <message>
        <source>Figure %1. No residuals, since no arc was fitted.</source>
        <translation>图 %1：没有残差，因为没有拟合出圆弧。</translation>
    </message>
    <message>
        <source>Figure %1. Residuals of the readings, observed minus adjusted, right and up positive, along the slider coordinate. Circles: horizontal, diamonds: vertical; filled: axis at 0°, hollow: 180°.</source>
        <translation>图 %1：读数的残差，观测值减平差值，向右、向上为正，沿滑块坐标绘制。圆形：水平，菱形：竖直；实心：轴在 0°，空心：180°。</translation>
    </message>
    <message>
        <source>Grey band: ±1σ, broken lines: ±3σ of the stated noise (σ = %1 horizontal, %2 vertical).</source>
        <translation>灰带：±1σ，虚线：±3σ，按给定噪声（水平 σ = %1，竖直 σ = %2）。</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Arcs and residuals</source>
        <translation>圆弧和残差</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>v horiz.
(″)</source>
        <extracomment>heads of narrow columns: the residual of the horizontal, then that of the vertical circle</extracomment>
        <translation>v 水平
(″)</translation>
    </message>
    <message>
        <source>v vert.
(″)</source>
        <translation>v 竖直
(″)</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>unusable</source>
        <translation>无法使用</translation>
    </message>
    <message>
        <source>%1 first entered as %2</source>
        <extracomment>%1: what was read, as &quot;vertical reading&quot;; %2: as it was typed at first</extracomment>
        <translation>%1最初录入为 %2</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>Readings with the axis at %1</source>
        <translation>轴位 %1 的读数</translation>
    </message>
    <message>
        <source>Pointing zero: horizontal α0 = %1, vertical β0 = %2</source>
        <translation>瞄准零位：水平 α0 = %1，竖直 β0 = %2</translation>
    </message>
    <message>
        <source>Sighted again %1</source>
        <extracomment>%1: &quot;before them in face 2: 170°, 90°; after the readings in face 1: …&quot;</extracomment>
        <translation>再次照准：%1</translation>
    </message>
    <message>
        <source>No readings.</source>
        <translation>没有读数。</translation>
    </message>
    <message>
        <source>v: residual, observed minus adjusted, right and up positive. φ: arc angle from +x, counter-clockwise as the observer sees it.</source>
        <translation>v：残差，观测值减平差值，向右、向上为正。φ：自 +x 起的圆弧角，观测者看去逆时针为正。</translation>
    </message>
    <message>
        <source>w = v/(s0 σ √r): standardised residual, s0 = %1; — where no other reading checks the reading. * marks residuals with |w| &gt; %2, for information: no reading is left out because of its residual.</source>
        <translation>w = v/(s0 σ √r)：标准化残差，s0 = %1；— 表示没有其他读数检核该读数。* 标出 |w| &gt; %2 的残差，仅供参考：没有读数因残差而被去掉。</translation>
    </message>
    <message>
        <source>Readings changed, excluded or not usable, with the axis at %1</source>
        <translation>轴位 %1 中更改、排除或无法使用的读数</translation>
    </message>
    <message>
        <source>1 finding: see below.</source>
        <translation>1 条提示：见下文。</translation>
    </message>
    <message>
        <source>%1 findings: see below.</source>
        <translation>%1 条提示：见下文。</translation>
    </message>
    <message>
        <source>Entries that could not be used</source>
        <translation>无法使用的输入项</translation>
    </message>
    <message>
        <source>Arc centres and radii</source>
        <translation>圆心和半径</translation>
    </message>
    <message>
        <source>No arc could be fitted.</source>
        <translation>没有拟合出圆弧。</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>No. %1</source>
        <extracomment>the number of a report</extracomment>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>Acceptance report</source>
        <translation>验收报告</translation>
    </message>
    <message>
        <source>Intersection of a rotatable arc guideway</source>
        <translation>可转动弧形导轨的相交度</translation>
    </message>
    <message>
        <source>Note</source>
        <extracomment>how serious a finding is: Note, Warning or Error</extracomment>
        <translation>提示</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>None: nothing in the data speaks against the result.</source>
        <translation>无：数据中没有对结果不利之处。</translation>
    </message>
    <message>
        <source>None in the data, but see the undetectable effects above.</source>
        <translation>数据中没有；但请见上文所列这些读数无法检出的效应。</translation>
    </message>
    <message>
        <source>Model and readings disagree, see “Gap between model and readings”. %1.</source>
        <translation>模型与读数不符，见“模型与读数的差距”。%1。</translation>
    </message>
    <message>
        <source>tan e = y/L (planar, as published)</source>
        <translation>tan e = y/L（平面，按原文）</translation>
    </message>
    <message>
        <source>tan e = y/√(x² + L²) (exact)</source>
        <translation>tan e = y/√(x² + L²)（精确）</translation>
    </message>
    <message>
        <source>Each arc is fitted by rigorous orthogonal least squares on the angles read: the centre, the radius and the slider&apos;s place at each sighting are free, both circles carry errors of the stated σ. Horizontal angle tan a = x/L, vertical angle %1; frame at the theodolite, x right, y up.</source>
        <translation>每个圆弧对所读角度作严格的正交最小二乘拟合：圆心、半径和每次照准时滑块的位置均为自由量，两个度盘的误差均按给定的 σ。水平角 tan a = x/L，竖直角 %1；坐标系在经纬仪处，x 向右，y 向上。</translation>
    </message>
    <message>
        <source>Positions at the same axis angle share one centre and one radius; all pointing zeros are estimated too, with their stated uncertainty.</source>
        <translation>复测的轴位共有一个圆心和一个半径；所有瞄准零位按给定的不确定度一并估计。</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Operator: %1, date</source>
        <extracomment>below a line to be signed and dated; %1: the name</extracomment>
        <translation>操作者：%1，日期</translation>
    </message>
    <message>
        <source>Authorised by: %1, date</source>
        <translation>批准人：%1，日期</translation>
    </message>
    <message>
        <source>Operator, date</source>
        <translation>操作者，日期</translation>
    </message>
    <message>
        <source>Authorised by, date</source>
        <translation>批准人，日期</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Intersection Δd = (y(O1) − y(O2))/2: half the difference of the heights of the arc centres at 0° (O1) and at 180° (O2), y up; positive if the centre is higher at 0°.</source>
        <translation>相交度 Δd = (y(O1) − y(O2))/2：0°（O1）和 180°（O2）两圆心高度之差的一半，y 向上；0° 时圆心较高则为正。</translation>
    </message>
    <message>
        <source>Guard band w = U (coverage %1 %).</source>
        <translation>保护带 w = U（包含概率 %1 %）。</translation>
    </message>
    <message>
        <source>Guard band w = U (coverage %1 %): a verdict is wrong with a probability of at most %2 % (JCGM 106, ILAC-G8).</source>
        <translation>保护带 w = U（包含概率 %1 %）：误判的概率不超过 %2 %（JCGM 106，ILAC-G8）。</translation>
    </message>
    <message>
        <source>Agreed by: %1</source>
        <translation>约定方：%1</translation>
    </message>
    <message>
        <source>none of %1 rows of readings</source>
        <translation>%1 行读数中没有</translation>
    </message>
    <message>
        <source>%1 × without a note</source>
        <extracomment>%1: the number of excluded rows, %2: their note</extracomment>
        <translation>%1 × 无备注</translation>
    </message>
    <message>
        <source>%1 × “%2”</source>
        <translation>%1 × “%2”</translation>
    </message>
    <message>
        <source>%1 × for other reasons</source>
        <translation>%1 × 其他原因</translation>
    </message>
    <message>
        <source>%1 of %2 rows of readings: %3</source>
        <extracomment>excluded rows; %3: their numbers by note, such as &quot;2 × “blunder”&quot;</extracomment>
        <translation>%2 行读数中的 %1 行：%3</translation>
    </message>
    <message>
        <source>%1, estimated along with the arcs</source>
        <extracomment>%1: effects</extracomment>
        <translation>%1，与圆弧一并估计</translation>
    </message>
    <message>
        <source>none</source>
        <extracomment>corrections: none</extracomment>
        <translation>无</translation>
    </message>
    <message>
        <source>one entry in the journal, see below</source>
        <translation>更改日志中有 1 条更改，见下文</translation>
    </message>
    <message>
        <source>one entry in the journal of the session, left out here</source>
        <translation>测量记录的更改日志中有 1 条更改，此处略去</translation>
    </message>
    <message>
        <source>%1 entries in the journal, see below</source>
        <translation>更改日志中有 %1 条更改，见下文</translation>
    </message>
    <message>
        <source>%1 entries in the journal of the session, left out here</source>
        <translation>测量记录的更改日志中有 %1 条更改，此处略去</translation>
    </message>
    <message>
        <source>%1; L and R0 without thermal correction</source>
        <extracomment>%1: the temperature</extracomment>
        <translation>%1；L 和 R0 未作热膨胀改正</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the changes of two lengths: &quot;L 0.101 mm&quot; and &quot;R0 0.032 mm&quot;</extracomment>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>Measurand</source>
        <translation>被测量</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>判定规则</translation>
    </message>
    <message>
        <source>Exclusions</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>改正</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>适用范围</translation>
    </message>
    <message>
        <source>; </source>
        <extracomment>between clauses</extracomment>
        <translation>；</translation>
    </message>
    <message>
        <source>Instrument record: %1.</source>
        <translation>仪器档案：%1。</translation>
    </message>
    <message>
        <source>Instrument record: %1 of %2.</source>
        <translation>仪器档案：%1，%2。</translation>
    </message>
    <message>
        <source>Device history</source>
        <translation>设备历史</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Δd over time</source>
        <translation>Δd 随时间的变化</translation>
    </message>
    <message>
        <source>Alidade %1 · Device history</source>
        <translation>Alidade %1 · 设备历史</translation>
    </message>
    <message>
        <source>Sessions: %1, %2</source>
        <translation>测量记录：%1，%2</translation>
    </message>
    <message>
        <source>Device history: %1</source>
        <translation>设备历史：%1</translation>
    </message>
    <message>
        <source>The results of this device history, to be read by programs</source>
        <translation>本设备历史的结果，供程序读取</translation>
    </message>
    <message>
        <source>σ compensator</source>
        <translation>补偿器 σ</translation>
    </message>
    <message>
        <source>tilt across the line of sight %1″</source>
        <translation>垂直于视线的倾斜 %1″</translation>
    </message>
    <message>
        <source>tilt along the line of sight %1″</source>
        <translation>沿视线的倾斜 %1″</translation>
    </message>
    <message>
        <source>corrected by the instrument: %1</source>
        <extracomment>%1: words such as &quot;inclination collimation&quot;, or &quot;none&quot;</extracomment>
        <translation>仪器已改正：%1</translation>
    </message>
    <message>
        <source>Check of this installation</source>
        <translation>本安装的检查</translation>
    </message>
    <message>
        <source>Every number is compared with one computed without this program.</source>
        <translation>每个数值都与不用本程序求得的数值比较。</translation>
    </message>
    <message>
        <source>Deviations and tolerances are relative to the expected number.</source>
        <translation>偏差和允许偏差均相对于期望值。</translation>
    </message>
    <message>
        <source>%1 · Check of this installation</source>
        <translation>%1 · 本安装的检查</translation>
    </message>
    <message>
        <source>The results of this check, to be read by programs</source>
        <translation>本次检查的结果，供程序读取</translation>
    </message>
    <message>
        <source>The PDF cannot be read (it takes more memory or time than a report does): choose another file</source>
        <translation>无法读取该 PDF（所需内存或时间超过一份报告所需）：请另选文件</translation>
    </message>
    <message>
        <source>no entry was changed after it was recorded</source>
        <translation>记录后没有任何条目被更改</translation>
    </message>
    <message>
        <source>Line of sight offset</source>
        <translation>视线偏距</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <extracomment>%1: date, time and zone, as 2026-03-14T15:09:26+01:00</extracomment>
        <translation>读取于 %1</translation>
    </message>
    <message>
        <source>return code %1</source>
        <extracomment>of the instrument, as 0 or 1284</extracomment>
        <translation>返回码 %1</translation>
    </message>
    <message>
        <source>instrument %1</source>
        <translation>仪器 %1</translation>
    </message>
    <message>
        <source>Inset: the arc centres O1 and O2 of the fit, with the axis midway between them. The heavy line is Δd, fit only; the bar at its end is the expanded uncertainty U. Each ellipse contains its centre with a probability of %1 %.</source>
        <translation>插图：拟合的圆心 O1 和 O2，轴在其正中。粗线为仅拟合 Δd，其端部的误差棒为扩展不确定度 U。每个椭圆以 %1 % 的概率包含其圆心。</translation>
    </message>
    <message>
        <source>The intersection Δd = (y(O1) − y(O2))/2 is half the difference of the heights of the arc centres at 0° (O1) and 180° (O2). The share of the readings in its uncertainty is scaled by their scatter (s0); pointing zeros and distance enter with their stated uncertainty. The expanded uncertainty U of Δd, fit only, is k times the combined standard uncertainty, with k from Student&apos;s distribution with ν effective degrees of freedom. Δd, measured, includes every effect of the catalogue, with its plausible size (1σ) as prior knowledge; its U also covers other explanations of the readings.</source>
        <translation>相交度 Δd = (y(O1) − y(O2))/2 是 0°（O1）和 180°（O2）两圆心高度之差的一半。读数对其不确定度的贡献按离散（s0）放大；瞄准零位和距离按其给定的不确定度计入。仅拟合 Δd 的扩展不确定度 U 为合成标准不确定度的 k 倍，k 取自有效自由度为 ν 的 t 分布。实测 Δd 包含目录中的每个效应，以其合理大小（1σ）作为先验信息；其 U 还涵盖对读数的其他解释。</translation>
    </message>
    <message>
        <source>Accepted: d + U ≤ %1, measured, and |Δd| + U ≤ %1, fit only; rejected: d − U &gt; %1, measured. Otherwise, or if the gap has no known cause: undecided.</source>
        <translation>合格：实测 d + U ≤ %1 且仅拟合 |Δd| + U ≤ %1；不合格：实测 d − U &gt; %1。其他情况或差距原因不明时：待定。</translation>
    </message>
    <message>
        <source>Accepted: |Δd| + U ≤ %1; rejected: |Δd| − U &gt; %1; each measured and fit only. Otherwise, or if the gap has no known cause: undecided.</source>
        <translation>合格：|Δd| + U ≤ %1；不合格：|Δd| − U &gt; %1；实测 Δd 与仅拟合 Δd 均须满足。其他情况或差距原因不明时：待定。</translation>
    </message>
    <message>
        <source>Accepted: |Δd| + U ≤ %1; rejected: |Δd| − U &gt; %1; each for Δd, fit only. Otherwise: undecided.</source>
        <translation>合格：|Δd| + U ≤ %1；不合格：|Δd| − U &gt; %1；均针对仅拟合 Δd。其他情况：待定。</translation>
    </message>
    <message>
        <source>known sizes in Δd, measured: %1</source>
        <translation>实测 Δd 采用的已知值：%1</translation>
    </message>
    <message>
        <source>The curve is the form. Hollow marks are the value that each sighting gives for the form, with everything else in the model.</source>
        <translation>曲线是形式。空心标记是各次照准给出的形式值，此时其余一切均列入模型。</translation>
    </message>
    <message>
        <source>Filled marks: these values minus the form, fitted without the sighting itself.</source>
        <translation>实心标记：这些值减去不含该次照准拟合的形式。</translation>
    </message>
    <message>
        <source>Filled marks: these values minus the form.</source>
        <translation>实心标记：这些值减去形式。</translation>
    </message>
    <message>
        <source>Broken lines: ±1σ of the most sensitive sighting, from the stated noise.</source>
        <translation>虚线：按给定噪声，最灵敏的一次照准的 ±1σ。</translation>
    </message>
    <message>
        <source>Grey: where the model holds.</source>
        <translation>灰色：模型成立之处。</translation>
    </message>
    <message>
        <source>End of the report</source>
        <translation>报告结束</translation>
    </message>
    <message>
        <source>The results relate only to the item measured. Not to be reproduced except in full.</source>
        <translation>结果仅与被测物有关。除完整复制外，不得复制本报告。</translation>
    </message>
    <message>
        <source>View along the axis: the arc centre at 0° with its U, Δd upwards and Δz towards the theodolite; at 180° the centre is on the opposite side.</source>
        <translation>沿回转轴的视图：0° 时的圆心及其 U，Δd 向上，Δz 朝向经纬仪；180° 时圆心位于对侧。</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>状况</translation>
    </message>
    <message>
        <source>Received on</source>
        <translation>接收日期</translation>
    </message>
    <message>
        <source>“%1”: %2.</source>
        <translation>“%1”：%2。</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>instrument without a name</source>
        <translation>未命名的仪器</translation>
    </message>
    <message>
        <source>Axes and circles</source>
        <translation>轴系与度盘</translation>
    </message>
    <message>
        <source>Instrument check</source>
        <translation>仪器检查</translation>
    </message>
    <message>
        <source>Values over the rounds</source>
        <translation>各测回的变化</translation>
    </message>
    <message>
        <source>Alidade %1 · Instrument check</source>
        <translation>Alidade %1 · 仪器检查</translation>
    </message>
    <message>
        <source>Instrument check: %1</source>
        <translation>仪器检查：%1</translation>
    </message>
    <message>
        <source>after the readings in %1: %2, %3</source>
        <translation>读数之后，%1：%2，%3</translation>
    </message>
    <message>
        <source>before the readings in %1: %2, %3</source>
        <translation>读数之前，%1：%2，%3</translation>
    </message>
    <message>
        <source>Control chart. Bars: ± U, as in the table. Broken lines: centre line ± three standard uncertainties of each value, without the part common to all values; dotted: ± three times the scatter from the moving range. EWMA: exponentially weighted average with λ = 0.2 and its exact limits.</source>
        <translation>控制图。误差棒：± U，与表中相同。虚线：中心线 ± 各值标准不确定度（不含各值共有部分）的三倍；点线：由移动极差所见离散的三倍。EWMA：λ = 0.2 的指数加权平均及其精确界限。</translation>
    </message>
    <message>
        <source>Rounds are drawn side by side.</source>
        <translation>各测回并列。</translation>
    </message>
    <message>
        <source>The tolerance applies to the distance d = √(Δd² + Δz²) of the centre from the axis, with Δz perpendicular to the plane of the arc.</source>
        <translation>允差针对圆心到轴的距离 d = √(Δd² + Δz²)，Δz 垂直于圆弧平面。</translation>
    </message>
    <message>
        <source>%1; relative to the stated values at 20 °C: %2</source>
        <extracomment>%1: the temperature, %2: what L and R0 change by</extracomment>
        <translation>%1；与 20 °C 时的给定值相比：%2</translation>
    </message>
</context>
<context>
    <name>ReportPart</name>
    <message>
        <source>Picture of the arcs</source>
        <translation>圆弧图</translation>
    </message>
    <message>
        <source>Picture of the residuals</source>
        <translation>残差图</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Journal of changes</source>
        <translation>更改日志</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Uncertainty budget</source>
        <translation>不确定度预算</translation>
    </message>
    <message>
        <source>Gap between model and readings</source>
        <translation>模型与读数的差距</translation>
    </message>
    <message>
        <source>Closures</source>
        <translation>闭合差</translation>
    </message>
    <message>
        <source>Effects undetectable here</source>
        <translation>这些读数无法检出的效应</translation>
    </message>
    <message>
        <source>Signature lines</source>
        <translation>签字栏</translation>
    </message>
</context>
<context>
    <name>RowChoiceText</name>
    <message>
        <source>round %1</source>
        <translation>测回 %1</translation>
    </message>
    <message>
        <source>only %1</source>
        <translation>仅%1</translation>
    </message>
</context>
<context>
    <name>RowEntriesText</name>
    <message>
        <source>rounds side by side</source>
        <translation>测回并列</translation>
    </message>
</context>
<context>
    <name>RowMenuText</name>
    <message>
        <source>and %1 further</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>&amp;Rounds</source>
        <translation>测回(&amp;R)</translation>
    </message>
    <message>
        <source>All Rounds</source>
        <translation>所有测回</translation>
    </message>
    <message>
        <source>Round %1</source>
        <translation>测回 %1</translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation>盘位(&amp;F)</translation>
    </message>
    <message>
        <source>Both Faces</source>
        <translation>双盘位</translation>
    </message>
</context>
<context>
    <name>Sample</name>
    <message>
        <source>Table I of the paper</source>
        <translation>论文的表 I</translation>
    </message>
    <message>
        <source>A whole measurement, with a gap: two radii that differ by 2 mm</source>
        <translation>一次完整的测量，带有差距：两个半径相差 2 mm</translation>
    </message>
    <message>
        <source>A clean session</source>
        <translation>无误差的测量记录</translation>
    </message>
    <message>
        <source>Nothing but noise: what a sound fit looks like</source>
        <translation>只有噪声：良好拟合的样子</translation>
    </message>
    <message>
        <source>One reading misread</source>
        <translation>一个误读的读数</translation>
    </message>
    <message>
        <source>One reading is 10′ wrong: it is found, and the intended reading is suggested</source>
        <translation>一个读数错了 10′：找出该读数，并给出应有的读数</translation>
    </message>
    <message>
        <source>Both faces</source>
        <translation>双盘位</translation>
    </message>
    <message>
        <source>Collimation and trunnion tilt are found, and Δd is free of them</source>
        <translation>找出照准差和横轴误差，Δd 不受其影响</translation>
    </message>
    <message>
        <source>A tilted trunnion axis</source>
        <translation>横轴误差</translation>
    </message>
    <message>
        <source>One cause, found with its size</source>
        <translation>一个原因，连同其大小一并找出</translation>
    </message>
    <message>
        <source>The same fault, one face</source>
        <translation>同样的误差，单盘位</translation>
    </message>
    <message>
        <source>Ambiguous: indistinguishable causes, and the readings to take next</source>
        <translation>不能唯一确定：彼此无法区分的原因，以及接下来应测的读数</translation>
    </message>
    <message>
        <source>Two causes at once</source>
        <translation>两个原因同时存在</translation>
    </message>
    <message>
        <source>A trunnion tilt and a vertical circle that drifts</source>
        <translation>横轴误差和竖直度盘漂移</translation>
    </message>
    <message>
        <source>A knocked tripod</source>
        <translation>三脚架碰动</translation>
    </message>
    <message>
        <source>A jump after 25 of 36 readings</source>
        <translation>36 个读数中第 25 个之后的突跳</translation>
    </message>
    <message>
        <source>Noise larger than stated</source>
        <translation>噪声大于给定值</translation>
    </message>
    <message>
        <source>6″ where 2″ are stated, and nothing else wrong</source>
        <translation>给定 2″ 而实为 6″，其他均无问题</translation>
    </message>
    <message>
        <source>A guideway out of shape</source>
        <translation>导轨变形</translation>
    </message>
    <message>
        <source>A known trunnion tilt</source>
        <translation>已知的横轴误差</translation>
    </message>
    <message>
        <source>The instrument record states the trunnion tilt: nothing is left to explain</source>
        <translation>仪器档案已载有该横轴误差：没有什么需要解释</translation>
    </message>
    <message>
        <source>An outdated record</source>
        <translation>过时的仪器档案</translation>
    </message>
    <message>
        <source>The instrument was knocked after its check: the outdated value is detected</source>
        <translation>仪器在检查之后受过碰撞：检出已过时的值</translation>
    </message>
    <message>
        <source>A radius with five periods in a turn: the form is found, with its size</source>
        <translation>半径每转变化五个周期：求得形式及其大小</translation>
    </message>
    <message>
        <source>A dented guideway</source>
        <translation>导轨凹陷</translation>
    </message>
    <message>
        <source>The form of an uncatalogued effect, and where the model holds</source>
        <translation>目录之外效应的形式，以及模型成立之处</translation>
    </message>
    <message>
        <source>A settling tripod</source>
        <translation>三脚架趋于稳定</translation>
    </message>
    <message>
        <source>A form in time: only the first quarter deviates</source>
        <translation>随时间的形式：只有前四分之一有偏移</translation>
    </message>
    <message>
        <source>An effect of one&apos;s own</source>
        <translation>自定义效应</translation>
    </message>
    <message>
        <source>A joint of the rail, typed as a formula: the cause, with its size</source>
        <translation>以公式输入的导轨接头：原因及其大小</translation>
    </message>
</context>
<context>
    <name>SealSession</name>
    <message>
        <source>Seal the session</source>
        <translation>封存测量记录</translation>
    </message>
</context>
<context>
    <name>SideViewText</name>
    <message>
        <source>Along the axis</source>
        <translation>沿回转轴观察</translation>
    </message>
    <message>
        <source>Δz →</source>
        <extracomment>an arrow to the side where the theodolite stands</extracomment>
        <translation>Δz →</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>“%1” cannot be imported.

%2</source>
        <translation>“%1”无法导入。

%2</translation>
    </message>
</context>
<context>
    <name>StateNoise</name>
    <message>
        <source>State σ of the circles</source>
        <translation>给定度盘的 σ</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>entries that are not shown</source>
        <translation>未显示的输入项</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 行</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>a row</source>
        <translation>一行</translation>
    </message>
    <message>
        <source>1 entry differs</source>
        <translation>1 处输入项不同</translation>
    </message>
    <message>
        <source>%1 entries differ</source>
        <translation>%1 处输入项不同</translation>
    </message>
</context>
<context>
    <name>ToleranceScale</name>
    <message>
        <source>tolerance %1</source>
        <extracomment>the limit on a scale; %1: &quot;2.5 mm&quot;</extracomment>
        <translation>允差 %1</translation>
    </message>
</context>
<context>
    <name>TrialText</name>
    <message>
        <source>A dent of the radius, %1 at s = %2°</source>
        <translation>半径凹陷，在 s = %2° 处为 %1</translation>
    </message>
    <message>
        <source>A horizontal circle error with %2 periods a turn, %1</source>
        <translation>水平度盘误差，每圈 %2 个周期，%1</translation>
    </message>
    <message>
        <source>An instrument that settles, %1</source>
        <translation>仪器趋于稳定，%1</translation>
    </message>
    <message>
        <source>A distance that grows by %1</source>
        <translation>距离增长 %1</translation>
    </message>
    <message>
        <source>Refraction, %1 · sin 2e</source>
        <translation>折光，%1 · sin 2e</translation>
    </message>
    <message>
        <source>Backlash of the horizontal circle, %1 on the way back</source>
        <translation>水平度盘的回程差，返测时为 %1</translation>
    </message>
    <message>
        <source>A warp of order %2 out of the plane, %1</source>
        <translation>偏离平面的 %2 阶翘曲，%1</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>several causes</source>
        <translation>多个原因</translation>
    </message>
    <message>
        <source>an uncatalogued effect</source>
        <translation>目录之外的效应</translation>
    </message>
    <message>
        <source>no gap</source>
        <translation>无差距</translation>
    </message>
    <message>
        <source>no known cause</source>
        <translation>无已知原因</translation>
    </message>
    <message>
        <source>Knocked after %1 % of the rows: horizontal %2, vertical %3</source>
        <translation>在 %1 % 的行之后碰动：水平 %2，竖直 %3</translation>
    </message>
    <message>
        <source>Knocked after the pointing zero at %1: horizontal %2, vertical %3</source>
        <translation>在 %1 的瞄准零位之后碰动：水平 %2，竖直 %3</translation>
    </message>
    <message>
        <source>Radius + A cos %1s + B sin %1s with A = %2 mm, B = %3 mm</source>
        <translation>半径 + A cos %1s + B sin %1s，A = %2 mm，B = %3 mm</translation>
    </message>
    <message>
        <source>Noise: %1 times the stated noise</source>
        <translation>噪声为给定值的 %1 倍</translation>
    </message>
    <message>
        <source>No error was simulated.</source>
        <translation>没有模拟任何误差。</translation>
    </message>
    <message>
        <source>The trace of the error in the readings is %1 σ</source>
        <translation>该误差在读数中的痕迹为 %1 σ</translation>
    </message>
    <message>
        <source>; in these readings it looks like %1</source>
        <translation>；在这些读数中它看起来像%1</translation>
    </message>
    <message>
        <source>True Δd = %1 mm</source>
        <translation>真实 Δd = %1 mm</translation>
    </message>
    <message>
        <source>The truth was %1; the diagnosis was %2.</source>
        <translation>真实情况是%1；诊断是%2。</translation>
    </message>
    <message>
        <source>The error was found, although its trace is faint.</source>
        <translation>误差虽痕迹微弱，仍被找出。</translation>
    </message>
    <message>
        <source>The trace of the error is too faint to be found.</source>
        <translation>误差的痕迹过于微弱，无法找出。</translation>
    </message>
    <message>
        <source>The truth is in the group that the diagnosis names, which is no larger than necessary.</source>
        <translation>它在所指出的组内，且该组没有超出必要的范围。</translation>
    </message>
    <message>
        <source>The truth was %1; the diagnosis agrees.</source>
        <translation>真实情况是%1，诊断与之一致。</translation>
    </message>
    <message>
        <source> Δd with the causes covers the true Δd.</source>
        <translation>计入原因的 Δd 覆盖真值。</translation>
    </message>
    <message>
        <source> Δd with the causes misses the true Δd.</source>
        <translation>计入原因的 Δd 未覆盖真值。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>a number of an effect and its size: tilt about x +0.10°</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>an effect and its sizes</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source> or </source>
        <translation>或</translation>
    </message>
    <message>
        <source>Misread: %1, round %2, point %3, %4, %5 by %6</source>
        <translation>误读：%1、测回 %2、测点 %3、%4，%5偏差 %6</translation>
    </message>
</context>
<context>
    <name>ZeroText</name>
    <message>
        <source>Mean of %1 sightings: α0 %2 ± %3, β0 %4 ± %5 (1σ)</source>
        <translation>%1 次照准的平均值：α0 %2 ± %3，β0 %4 ± %5（1σ）</translation>
    </message>
    <message>
        <source>; the zero moved by %1 (α0) and %2 (β0)</source>
        <translation>；其间零位移动 %1（α0）和 %2（β0）</translation>
    </message>
    <message>
        <source>; without face 2, since not every position has it</source>
        <translation>；不含盘右，因为并非每个轴位都有</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ArcChart</name>
    <message>
        <source>Arcs and sighted points</source>
        <translation>圆弧和照准点</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ArcPlot</name>
    <message>
        <source>No usable readings yet.</source>
        <translation>尚无可用读数。</translation>
    </message>
    <message>
        <source>arc at %1</source>
        <translation>圆弧 %1</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>residuals %1</source>
        <translation>残差 %1</translation>
    </message>
    <message>
        <source>%1 from the adjusted point</source>
        <translation>距平差点 %1</translation>
    </message>
    <message>
        <source>excluded from the fit</source>
        <translation>已从拟合中排除</translation>
    </message>
    <message>
        <source>%1 sighted points, %2 fitted arcs, residuals drawn %3</source>
        <translation>%1 个照准点，%2 个拟合圆弧，残差按 %3 放大绘制</translation>
    </message>
    <message>
        <source>Should be: strokes point in all directions, O1 and O2 lie within the tolerance.</source>
        <translation>应为：短线指向各个方向，O1 和 O2 在允差之内。</translation>
    </message>
    <message>
        <source>Should be: strokes point in all directions, O1 and O2 lie close to the axis.</source>
        <translation>应为：短线指向各个方向，O1 和 O2 靠近轴。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::BenchDisplay</name>
    <message>
        <source>Large Display</source>
        <translation>大字显示</translation>
    </message>
    <message>
        <source>Next entry</source>
        <translation>下一个输入项</translation>
    </message>
    <message>
        <source>Expected reading</source>
        <translation>预期读数</translation>
    </message>
    <message>
        <source>Reading entered last</source>
        <translation>最后录入的读数</translation>
    </message>
    <message>
        <source>Result so far</source>
        <translation>目前结果</translation>
    </message>
    <message>
        <source>All readings are taken</source>
        <translation>所有读数均已读取</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>Tolerance and verdict</source>
        <translation>允差和判定</translation>
    </message>
    <message>
        <source>Notes on the verdict</source>
        <translation>判定的说明</translation>
    </message>
</context>
<context>
    <name>alidade::ui::BlindTrialDialog</name>
    <message>
        <source>Blind Trial</source>
        <translation>盲测</translation>
    </message>
    <message>
        <source>any plan</source>
        <translation>任意计划</translation>
    </message>
    <message>
        <source>any error, or none</source>
        <translation>任意误差，或无误差</translation>
    </message>
    <message>
        <source>clearly, at 6 to 25 σ</source>
        <translation>明显，6 至 25 σ</translation>
    </message>
    <message>
        <source>faintly, at 2 to 6 σ</source>
        <translation>微弱，2 至 6 σ</translation>
    </message>
    <message>
        <source>The same number and choices give the same trial; each draw increases the number by one</source>
        <translation>相同的编号和选择给出相同的盲测；每抽取一次编号加一</translation>
    </message>
    <message>
        <source>Trial to draw</source>
        <translation>要抽取的盲测</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>读数计划(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Truth</source>
        <translation>真实情况(&amp;T)</translation>
    </message>
    <message>
        <source>S&amp;hows</source>
        <translation>显著程度(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>编号(&amp;N)</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>真实情况</translation>
    </message>
    <message>
        <source>&amp;Draw a trial</source>
        <translation>抽取一个盲测(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Open the seal</source>
        <translation>启封(&amp;O)</translation>
    </message>
    <message>
        <source>Sho&amp;w in main window</source>
        <translation>在主窗口中显示(&amp;W)</translation>
    </message>
    <message>
        <source>Opens the session of the trial as a new session; its truth stays sealed</source>
        <translation>将该盲测的测量记录作为新测量记录打开；其真实情况仍然密封</translation>
    </message>
    <message>
        <source>Number of trials in one run</source>
        <translation>一次进行的盲测个数</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Diagnosis of trial %1, plan %2</source>
        <translation>盲测 %1 的诊断，读数计划 %2</translation>
    </message>
    <message>
        <source>No trial drawn yet</source>
        <translation>尚未抽取盲测</translation>
    </message>
    <message>
        <source>A session is simulated from hidden true values, following the plan. The diagnosis knows only the readings; then you open the seal.</source>
        <translation>按读数计划，由隐藏的真值模拟出一份测量记录。诊断只知道读数；然后由您启封。</translation>
    </message>
    <message>
        <source>Right. </source>
        <translation>正确。</translation>
    </message>
    <message>
        <source>Wrong. </source>
        <translation>错误。</translation>
    </message>
    <message>
        <source>Sealed. The diagnosis is complete: open the seal to see what was simulated.</source>
        <translation>已密封。诊断已完成：启封即可看到模拟了什么。</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Dr&amp;aw many, open all:</source>
        <translation>抽取多个并全部启封(&amp;A)：</translation>
    </message>
</context>
<context>
    <name>alidade::ui::BudgetPanel</name>
    <message>
        <source>Budget</source>
        <translation>不确定度预算</translation>
    </message>
    <message>
        <source>No arc is fitted yet, so there is no budget.</source>
        <translation>尚未拟合出圆弧，因此没有不确定度预算。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ChangeReasonBar</name>
    <message>
        <source>Reason for the change</source>
        <translation>更改的原因</translation>
    </message>
    <message>
        <source>Optional: Ctrl+R, type, Enter</source>
        <translation>可不填：按 Ctrl+R，录入，按 Enter</translation>
    </message>
    <message>
        <source>Why was this entry changed? %1</source>
        <translation>为何更改此项？%1</translation>
    </message>
    <message>
        <source>Why were these %1 entries changed?</source>
        <translation>为何更改这 %1 项？</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ChangedFileBar</name>
    <message>
        <source>Changed file</source>
        <translation>文件已更改</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Shows what differs, and offers to reload, to save elsewhere or to overwrite</source>
        <translation>显示有何不同，并可重新载入、另存或覆盖</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>You are asked again before the file is overwritten</source>
        <translation>覆盖文件之前会再次询问</translation>
    </message>
    <message>
        <source>“%1” was written by another program or window.</source>
        <translation>“%1”已被其他程序或窗口写入。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Writes the session into its file again</source>
        <translation>将测量记录重新写入其文件</translation>
    </message>
    <message>
        <source>You are asked again before the session is closed</source>
        <translation>关闭测量记录之前会再次询问</translation>
    </message>
    <message>
        <source>The file “%1” was deleted, moved or renamed: only this window has the session until you save it.</source>
        <translation>文件“%1”已被删除、移动或重命名：在保存之前，只有此窗口保有该测量记录。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ChartFiles</name>
    <message>
        <source>&amp;Copy Picture	Ctrl+C</source>
        <translation>复制图片(&amp;C)	Ctrl+C</translation>
    </message>
    <message>
        <source>Save as &amp;SVG…</source>
        <translation>另存为 SVG(&amp;S)…</translation>
    </message>
    <message>
        <source>Save as &amp;PNG…</source>
        <translation>另存为 PNG(&amp;P)…</translation>
    </message>
    <message>
        <source>Save &amp;Numbers as CSV…</source>
        <translation>数据另存为 CSV(&amp;N)…</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CheckChart</name>
    <message>
        <source>Chart of the check</source>
        <translation>检查的图表</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CheckInput</name>
    <message>
        <source>not stated</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>σ of a value observed once in both faces, as in a data sheet according to ISO 17123-3</source>
        <translation>盘左、盘右各观测一次所得的值，如按 ISO 17123-3 的说明书所载</translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Rows Typed</source>
        <translation>录入的行(&amp;R)</translation>
    </message>
    <message>
        <source>Files of readings</source>
        <translation>读数文件</translation>
    </message>
    <message>
        <source>&amp;Open Files…</source>
        <translation>打开文件(&amp;O)…</translation>
    </message>
    <message>
        <source>R&amp;emove</source>
        <translation>移除(&amp;E)</translation>
    </message>
    <message>
        <source>decimal degrees</source>
        <translation>十进制度</translation>
    </message>
    <message>
        <source>gon</source>
        <translation>gon</translation>
    </message>
    <message>
        <source>degrees.minutes seconds</source>
        <translation>度.分秒</translation>
    </message>
    <message>
        <source>from the readings</source>
        <translation>按读数判断</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>高度角</translation>
    </message>
    <message>
        <source>σ of a &amp;direction:</source>
        <translation>方向的 σ(&amp;D)：</translation>
    </message>
    <message>
        <source>σ of a &amp;zenith angle:</source>
        <translation>天顶距的 σ(&amp;Z)：</translation>
    </message>
    <message>
        <source>&amp;Plain numbers:</source>
        <translation>不带单位的数(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Vertical circle:</source>
        <translation>竖直度盘(&amp;V)：</translation>
    </message>
    <message>
        <source>Reading the files…</source>
        <translation>正在读取文件…</translation>
    </message>
    <message>
        <source>Instrument check</source>
        <translation>仪器检查</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>录入</translation>
    </message>
    <message>
        <source>The rows stay until they are cleared, even when the program ends</source>
        <translation>各行在清除之前一直保留，程序结束后也保留</translation>
    </message>
    <message>
        <source>Bring &amp;Back</source>
        <translation>恢复(&amp;B)</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>清除(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Instrument:</source>
        <translation>仪器(&amp;I)：</translation>
    </message>
    <message>
        <source>Its name or model, for the record and the report</source>
        <translation>其名称或型号，用于仪器档案和报告</translation>
    </message>
    <message>
        <source>Serial &amp;number:</source>
        <translation>序列号(&amp;N)：</translation>
    </message>
    <message>
        <source>Identifies the instrument in sessions and histories</source>
        <translation>测量记录和历史据此识别仪器</translation>
    </message>
    <message>
        <source>C&amp;hecked on:</source>
        <translation>检查日期(&amp;H)：</translation>
    </message>
    <message>
        <source>Year-month-day</source>
        <translation>年-月-日</translation>
    </message>
    <message>
        <source>Next check d&amp;ue:</source>
        <translation>下次检查到期(&amp;U)：</translation>
    </message>
    <message>
        <source>Year-month-day; kept in the instrument record</source>
        <translation>年-月-日；保存在仪器档案中</translation>
    </message>
    <message>
        <source>found from the two faces</source>
        <translation>按两个盘位之和判断</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CheckPlot</name>
    <message>
        <source>round, one station after another</source>
        <translation>测回，各测站依次</translation>
    </message>
    <message>
        <source>minus its mean (″)</source>
        <translation>减去平均值 (″)</translation>
    </message>
    <message>
        <source>residual (″)</source>
        <translation>残差 (″)</translation>
    </message>
    <message>
        <source>distance (m)</source>
        <translation>距离 (m)</translation>
    </message>
    <message>
        <source>collimation (″)</source>
        <translation>照准差 (″)</translation>
    </message>
    <message>
        <source>No distances are known.</source>
        <translation>没有已知的距离。</translation>
    </message>
    <message>
        <source>No complete round yet.</source>
        <translation>还没有完整的测回。</translation>
    </message>
    <message>
        <source>collimation c</source>
        <translation>照准差 c</translation>
    </message>
    <message>
        <source>index</source>
        <translation>指标差</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>定向</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>round %1</source>
        <translation>测回 %1</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>目标 %1</translation>
    </message>
    <message>
        <source>%1 points, at most %2</source>
        <translation>%1 个点，最大 %2</translation>
    </message>
    <message>
        <source>Should be: level from round to round. A slope shows a drift; a step shows that something moved.</source>
        <translation>应为：各测回之间保持水平；倾斜表示漂移，阶跃表示有变动。</translation>
    </message>
    <message>
        <source>Should be: an even band about 0 in every round, and no target with residuals of one sign only.</source>
        <translation>应为：每个测回都在 0 附近均匀分布，没有残差总为同一符号的目标。</translation>
    </message>
    <message>
        <source>Should be: level. A rise towards short distances shows an offset e of the line of sight from the axis: it grows as e/D.</source>
        <translation>应为：保持水平。向短距离方向升高表明视线偏离竖轴的偏距 e：其影响按 e/D 增大。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CheckRowsModel</name>
    <message>
        <source>Station</source>
        <translation>测站</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>Distance (m)</source>
        <translation>距离 (m)</translation>
    </message>
    <message>
        <source>Empty: only one station</source>
        <translation>留空：只有一个测站</translation>
    </message>
    <message>
        <source>Empty: determined from the repeated targets</source>
        <translation>留空：由目标再次出现得出</translation>
    </message>
    <message>
        <source>Any name, the same in both faces and all rounds</source>
        <translation>任意名称，两个盘位和所有测回相同</translation>
    </message>
    <message>
        <source>Empty: determined from the vertical circle</source>
        <translation>留空：由竖直度盘得出</translation>
    </message>
    <message>
        <source>341°52′24″, 341 52 24, 379.859gon, or plain numbers in the chosen unit</source>
        <translation>341°52′24″、341 52 24、379.859gon，或按所选单位的纯数字</translation>
    </message>
    <message>
        <source>Zenith angle, in the same formats as the horizontal reading</source>
        <translation>天顶距，格式同水平读数</translation>
    </message>
    <message>
        <source>Slope distance; may be empty</source>
        <translation>斜距；可留空</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CheckRowsTable</name>
    <message>
        <source>Rounds typed</source>
        <translation>录入的测回</translation>
    </message>
    <message>
        <source>Type, or paste from a spreadsheet (Ctrl+V); a first row of column names sets their order</source>
        <translation>录入，或从电子表格粘贴 (Ctrl+V)；首行若为列名则照其排列</translation>
    </message>
    <message>
        <source>The clipboard was not pasted: %1.</source>
        <translation>剪贴板内容未粘贴：%1。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ClosureBars</name>
    <message>
        <source>What must agree</source>
        <translation>必须一致的量</translation>
    </message>
    <message>
        <source>; with the causes %1</source>
        <translation>；计入原因后为 %1</translation>
    </message>
    <message>
        <source>with the causes</source>
        <translation>计入原因</translation>
    </message>
    <message>
        <source>band: ± U at %1 %</source>
        <translation>带：± U，%1 %</translation>
    </message>
    <message>
        <source>; arrow: beyond %1 U</source>
        <translation>；箭头：超过 %1 U</translation>
    </message>
</context>
<context>
    <name>alidade::ui::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Type a part of the command&apos;s name</source>
        <translation>请输入命令名称的一部分</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ConnectionDialog</name>
    <message>
        <source>Instrument Connection</source>
        <translation>仪器连接</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save Log…</source>
        <translation>保存日志(&amp;S)…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The connection stays open</source>
        <translation>连接继续保持</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>断开(&amp;C)</translation>
    </message>
    <message>
        <source>Save log of the connection</source>
        <translation>保存连接日志</translation>
    </message>
    <message>
        <source>Ta&amp;ke Reading</source>
        <translation>读取读数(&amp;K)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ConnectionForm</name>
    <message>
        <source>GeoCOM: Alidade asks</source>
        <translation>GeoCOM：由 Alidade 询问</translation>
    </message>
    <message>
        <source>GSI online: the instrument sends</source>
        <translation>GSI 联机：由仪器发送</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>偶</translation>
    </message>
    <message>
        <source>Odd</source>
        <translation>奇</translation>
    </message>
    <message>
        <source>Next expected entry</source>
        <translation>下一个待读的输入项</translation>
    </message>
    <message>
        <source>Selected row</source>
        <translation>所选行</translation>
    </message>
    <message>
        <source>ttyUSB0 or a path</source>
        <translation>ttyUSB0 或路径</translation>
    </message>
    <message>
        <source>Port of the cable: choose it, or type a path such as /dev/pts/3</source>
        <translation>电缆所插的端口：可选择，或输入路径，如 /dev/pts/3</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>P&amp;rotocol</source>
        <translation>协议(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Baud rate</source>
        <translation>波特率(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Data bits</source>
        <translation>数据位(&amp;D)</translation>
    </message>
    <message>
        <source>P&amp;arity</source>
        <translation>校验(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;top bits</source>
        <translation>停止位(&amp;T)</translation>
    </message>
    <message>
        <source>Readings &amp;go to</source>
        <translation>读数填入(&amp;G)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::DiagnosisPanel</name>
    <message>
        <source>No sessions yet.</source>
        <translation>尚无测量记录。</translation>
    </message>
    <message>
        <source>Keep “%1” as an Effect…</source>
        <translation>将“%1”存为效应…</translation>
    </message>
    <message>
        <source>Writes an effect of your own, for this device or instrument, into a file</source>
        <translation>将自定义效应（属于该设备或仪器）写入文件</translation>
    </message>
    <message>
        <source>The sessions share no cause.</source>
        <translation>各测量记录没有共同的原因。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::Drafts</name>
    <message>
        <source>What is typed into this form would be lost in a crash: %1</source>
        <translation>录入该表单的内容在崩溃时会丢失：%1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::EffectsPanel</name>
    <message>
        <source>Effects estimated with the arcs</source>
        <translation>与圆弧一并估计的效应</translation>
    </message>
    <message>
        <source>Also estimate</source>
        <translation>一并估计</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Known Size…</source>
        <translation>已知值…</translation>
    </message>
    <message>
        <source>Type the size of the effect from a certificate or a check</source>
        <translation>请按证书或检查结果录入该效应的大小</translation>
    </message>
    <message>
        <source>“%1” is no effect of the catalogue; it is kept, but not estimated.</source>
        <translation>“%1”不是目录中的效应；予以保留，但不估计。</translation>
    </message>
    <message>
        <source>A ticked effect is estimated together with the arcs. Its share of U is in the budget under “model effects”.</source>
        <translation>勾选的效应与圆弧一并估计。其在 U 中所占部分见不确定度预算中的“模型效应”。</translation>
    </message>
    <message>
        <source>%1. Remedy: %2.</source>
        <translation>%1。措施：%2。</translation>
    </message>
    <message>
        <source>%1. Plausible size (1σ) %2. Remedy: %3.</source>
        <translation>%1。合理大小（1σ）%2。措施：%3。</translation>
    </message>
    <message>
        <source>no size in this row</source>
        <translation>本行没有大小</translation>
    </message>
    <message>
        <source>Effect of Your Own…</source>
        <translation>自定义效应…</translation>
    </message>
    <message>
        <source>Defines an effect by its formula, or changes the selected one</source>
        <translation>用公式输入效应，或修改所选的效应</translation>
    </message>
</context>
<context>
    <name>alidade::ui::EntryGuide</name>
    <message>
        <source>No entry here accepts “%1”.</source>
        <translation>此处没有接收“%1”的输入项。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::EntryTable</name>
    <message>
        <source>Nothing was entered: this cell takes no numbers.</source>
        <translation>没有录入任何内容：该单元格不接受数字。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::EntryWatch</name>
    <message>
        <source>%1: %2 was read where about %3 was expected. Look again.</source>
        <translation>%1：读数为 %2，而预期约为 %3。请再看一次。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ExportFlow</name>
    <message>
        <source>Export readings</source>
        <translation>导出读数</translation>
    </message>
    <message>
        <source>Export residuals</source>
        <translation>导出残差</translation>
    </message>
    <message>
        <source>Export result</source>
        <translation>导出结果</translation>
    </message>
    <message>
        <source>Export gap</source>
        <translation>导出差距</translation>
    </message>
    <message>
        <source>Export budget</source>
        <translation>导出不确定度预算</translation>
    </message>
    <message>
        <source>Save chart</source>
        <translation>保存图表</translation>
    </message>
    <message>
        <source>Computing what is exported…</source>
        <translation>正在计算要导出的内容…</translation>
    </message>
    <message>
        <source>There is nothing to export yet.

%1</source>
        <translation>尚无可导出的内容。

%1</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>已写入 %1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FileFlow</name>
    <message>
        <source>Import readings</source>
        <translation>导入读数</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 个文件</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>剪贴板</translation>
    </message>
    <message>
        <source>Reading the clipboard…</source>
        <translation>正在读取剪贴板…</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>1 row of readings imported from %1</source>
        <translation>已从 %1 导入 1 行读数</translation>
    </message>
    <message>
        <source>%1 rows of readings imported from %2</source>
        <translation>已从 %2 导入 %1 行读数</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>a pipe or a device</source>
        <translation>管道或设备</translation>
    </message>
    <message>
        <source>“%1” is %2: choose a file.</source>
        <translation>“%1”是%2：请选择文件。</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>打开测量记录</translation>
    </message>
    <message>
        <source>Opening “%1”…</source>
        <translation>正在打开“%1”…</translation>
    </message>
    <message>
        <source>“%1” cannot be opened.

%2</source>
        <translation>“%1”无法打开。

%2</translation>
    </message>
    <message>
        <source>Opening the session in “%1”…</source>
        <translation>正在打开“%1”中的测量记录…</translation>
    </message>
    <message>
        <source>Open report</source>
        <translation>打开报告</translation>
    </message>
    <message>
        <source>Opened the session attached to %1; it is not saved in a file of its own yet</source>
        <translation>已打开 %1 中所附的测量记录；它尚未保存在单独的文件中</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Reverted to %1; Undo restores the changes.</source>
        <translation>已恢复为 %1 的内容；撤销可恢复所做的更改。</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>保存测量记录</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>正在保存“%1”…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Checking “%1” for changes…</source>
        <translation>正在检查“%1”是否有更改…</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新载入</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FindBar</name>
    <message>
        <source>Find in the readings</source>
        <translation>在读数中查找</translation>
    </message>
    <message>
        <source>Previous (Shift+F3)</source>
        <translation>上一个 (Shift+F3)</translation>
    </message>
    <message>
        <source>Next (F3)</source>
        <translation>下一个 (F3)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FindingsPanel</name>
    <message>
        <source>Problems and findings</source>
        <translation>问题与提示</translation>
    </message>
    <message>
        <source>In order</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>没有问题。</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 个问题</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 个问题</translation>
    </message>
    <message>
        <source>1 missing entry</source>
        <translation>1 个缺项</translation>
    </message>
    <message>
        <source>%1 missing entries</source>
        <translation>%1 个缺项</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 个警告</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 个警告</translation>
    </message>
    <message>
        <source>1 note</source>
        <translation>1 个提示</translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation>%1 个提示</translation>
    </message>
    <message>
        <source>Before the latest changes: %1.</source>
        <translation>更改前：%1。</translation>
    </message>
    <message>
        <source>Model and readings disagree, see “Gap”. %1.</source>
        <translation>模型与读数不符，见“差距”。%1。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺项</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>%1 further entries are missing; they are listed once those above are filled in.</source>
        <translation>还缺 %1 项；上述各项补齐后，将列出其后的项。</translation>
    </message>
    <message>
        <source>%1 further entries cannot be used; they are listed once those above are corrected.</source>
        <translation>还有 %1 项无法使用；上述各项改正后，将列出其后的项。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FormChart</name>
    <message>
        <source>Form of the gap</source>
        <translation>差距的形式</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FormList</name>
    <message>
        <source>Keep as an Effect…</source>
        <translation>存为效应…</translation>
    </message>
    <message>
        <source>Makes the form an effect of your own, for this device or instrument</source>
        <translation>将此形式作为此设备或仪器的自定义效应</translation>
    </message>
</context>
<context>
    <name>alidade::ui::FormPlot</name>
    <message>
        <source>slider coordinate s (°)</source>
        <translation>滑块坐标 s (°)</translation>
    </message>
    <message>
        <source>t, elapsed share of the session</source>
        <translation>t，测量过程已经过的比例</translation>
    </message>
    <message>
        <source>azimuth a (°), right positive</source>
        <translation>方位角 a (°)，向右为正</translation>
    </message>
    <message>
        <source>elevation e (°), up positive</source>
        <translation>高度角 e (°)，向上为正</translation>
    </message>
    <message>
        <source>horizontal circle α (°)</source>
        <translation>水平度盘 α (°)</translation>
    </message>
    <message>
        <source>vertical circle β (°)</source>
        <translation>竖直度盘 β (°)</translation>
    </message>
    <message>
        <source>1: way there, −1: way back</source>
        <translation>1：往测，−1：返测</translation>
    </message>
    <message>
        <source>1: face 1, −1: face 2</source>
        <translation>1：盘左，−1：盘右</translation>
    </message>
    <message>
        <source>1: axis at 0°, −1: at 180°</source>
        <translation>1：轴位 0°，−1：轴位 180°</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: what a form displaces, %2: unit</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No single sighting shows this form clearly.</source>
        <translation>没有任何一次照准能清楚显示此形式。</translation>
    </message>
    <message>
        <source>after, held out</source>
        <translation>之后，留出的读数</translation>
    </message>
    <message>
        <source>after</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>the form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>±σ of a sighting</source>
        <translation>一次照准的 ±σ</translation>
    </message>
    <message>
        <source>the model holds</source>
        <translation>模型成立</translation>
    </message>
    <message>
        <source>before %1, after %2</source>
        <translation>之前 %1，之后 %2</translation>
    </message>
    <message>
        <source>round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Should be: hollow marks along the curve, filled ones an even band about 0.</source>
        <translation>应为：空心标记沿曲线，实心标记成为 0 附近均匀的带。</translation>
    </message>
    <message>
        <source>, held out %1</source>
        <translation>，该照准留出时 %1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapHeadline</name>
    <message>
        <source>No diagnosis</source>
        <translation>没有诊断</translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapMap</name>
    <message>
        <source>Where the gap lies</source>
        <translation>差距所在</translation>
    </message>
    <message>
        <source>%1 %2: %3 of the gap</source>
        <translation>%1：%2，占差距的 %3</translation>
    </message>
</context>
<context>
    <name>alidade::ui::GapPanel</name>
    <message>
        <source>Gap between model and readings</source>
        <translation>模型与读数的差距</translation>
    </message>
    <message>
        <source>Weigh the causes with the reference</source>
        <translation>用参考值权衡原因</translation>
    </message>
    <message>
        <source>Δd itself never depends on the reference.</source>
        <translation>Δd 本身从不依赖于参考值。</translation>
    </message>
    <message>
        <source>The difference of Δd from the reference then helps to distinguish the causes.
Δd with the causes depends on the readings alone, and so does the report.</source>
        <translation>Δd 与参考值相差多少有助于区分各原因。
计入原因的 Δd 只依据读数，报告也是如此。</translation>
    </message>
    <message>
        <source>Where the gap lies</source>
        <translation>差距所在</translation>
    </message>
    <message>
        <source>What must agree</source>
        <translation>必须一致的量</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>What may cause the gap</source>
        <translation>可能造成差距的原因</translation>
    </message>
    <message>
        <source>Vertical angle relation</source>
        <translation>竖直角关系式</translation>
    </message>
    <message>
        <source>ln B</source>
        <translation>ln B</translation>
    </message>
    <message>
        <source>Natural logarithm of the Bayes factor for the effect: above 0 the effect explains the readings better than no effect, above 5 far better, below 0 worse</source>
        <translation>该效应的贝叶斯因子的自然对数：大于 0 说明它比没有效应更能解释读数，大于 5 则好得多，小于 0 则更差</translation>
    </message>
    <message>
        <source>Visible σ</source>
        <translation>可见 σ</translation>
    </message>
    <message>
        <source>How far the effect shows in the readings, in σ of one reading</source>
        <translation>效应在读数中显现的程度，以单个读数的 σ 计</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Role of the effect in the diagnosis</source>
        <translation>该效应在诊断中的作用</translation>
    </message>
    <message>
        <source>look-alike</source>
        <translation>相似原因</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>in the model</source>
        <translation>已在模型中</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候选</translation>
    </message>
    <message>
        <source>No candidates.</source>
        <translation>没有候选。</translation>
    </message>
    <message>
        <source>Candidates, each by itself</source>
        <translation>候选，逐个考虑</translation>
    </message>
    <message>
        <source>No diagnosis</source>
        <translation>没有诊断</translation>
    </message>
    <message>
        <source>The readings are compared with the model as soon as there are any.</source>
        <translation>一有读数即与模型比较。</translation>
    </message>
    <message>
        <source>A&amp;dd to the model</source>
        <translation>加入模型(&amp;D)</translation>
    </message>
    <message>
        <source>A&amp;dd %1 to the model</source>
        <translation>将%1加入模型(&amp;D)</translation>
    </message>
    <message>
        <source>%1: nothing to add to the model</source>
        <translation>%1：没有可加入模型的内容</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Add the Ticked</source>
        <translation>加入所勾选的</translation>
    </message>
    <message>
        <source>Estimates the ticked causes along with the arcs; undone by Ctrl+Z</source>
        <translation>将所勾选的原因与圆弧一并估计；可用 Ctrl+Z 撤销</translation>
    </message>
    <message>
        <source>With Look-alikes</source>
        <translation>连同相似原因</translation>
    </message>
    <message>
        <source>Estimates the ticked causes and their look-alikes, each within its plausible size: U then covers every one of them</source>
        <translation>一并估计所勾选的原因及在此无法区分的所有原因，各在其合理大小之内：无论是哪一个，U 都涵盖</translation>
    </message>
    <message>
        <source>Take Out of the Model</source>
        <translation>从模型中去掉</translation>
    </message>
    <message>
        <source>Removes the ticked effects from the model</source>
        <translation>把所勾选的模型效应去掉</translation>
    </message>
    <message>
        <source>Should be: no part of a bar is far larger than the others; if one is, the gap lies there.</source>
        <translation>应为：条中没有哪一部分远大于其余部分；若有，差距即在该处。</translation>
    </message>
    <message>
        <source>Should be: every bar ends inside the grey band of ± U.</source>
        <translation>应为：每一条都止于 ± U 灰带之内。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HeadlineLines</name>
    <message>
        <source>Gap</source>
        <translation>差距</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HelpWindow</name>
    <message>
        <source>Guide</source>
        <translation>指南</translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation>指南的各页</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← 后退</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>后退 (Alt+Left)</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>前进 →</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>前进 (Alt+Right)</translation>
    </message>
    <message>
        <source>Find in this page (Ctrl+F)</source>
        <translation>在本页中查找 (Ctrl+F)</translation>
    </message>
    <message>
        <source>Not in this page</source>
        <translation>本页中没有</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HistoryChart</name>
    <message>
        <source>Control chart</source>
        <translation>控制图</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HistoryChoices</name>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>&amp;Quantity</source>
        <translation>量(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Baseline</source>
        <translation>基准阶段(&amp;B)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HistoryPanel</name>
    <message>
        <source>&amp;Device</source>
        <translation>设备(&amp;D)</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>What the history says</source>
        <translation>历史说明了什么</translation>
    </message>
    <message>
        <source>Two sessions compared</source>
        <translation>比较两份测量记录</translation>
    </message>
    <message>
        <source>Nothing yet: the history of a device begins with its second session.</source>
        <translation>尚无内容：设备的历史从第二份测量记录开始。</translation>
    </message>
    <message>
        <source>At least one of these two sessions does not belong to the device shown.</source>
        <translation>这两份测量记录中至少有一份不属于所示设备。</translation>
    </message>
    <message>
        <source>Select two sessions in the table (with Ctrl) to see whether the device has changed between them.</source>
        <translation>在表中选择两份测量记录（按住 Ctrl），查看设备在其间是否改变。</translation>
    </message>
    <message>
        <source>Sessions in the baseline</source>
        <translation>基准阶段的测量次数</translation>
    </message>
    <message>
        <source>all sessions</source>
        <translation>全部测量记录</translation>
    </message>
    <message>
        <source>The first sessions define centre line and limits for the later ones: choose those measured before any change</source>
        <translation>最初几次测量确定其后测量的中心线和控制限：请选择发生任何变化之前的测量</translation>
    </message>
</context>
<context>
    <name>alidade::ui::HistoryPlot</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Add sessions of a device, with the dates they were measured on.</source>
        <translation>请添加一台设备的测量记录及其测量日期。</translation>
    </message>
    <message>
        <source>trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>各段均值</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>± 3 σ, observed</source>
        <translation>± 3 σ（观测到的）</translation>
    </message>
    <message>
        <source>average (EWMA)</source>
        <translation>平均 (EWMA)</translation>
    </message>
    <message>
        <source>EWMA limits</source>
        <translation>EWMA 界限</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>: outside</source>
        <translation>：超出</translation>
    </message>
    <message>
        <source>the first value after a step of %1</source>
        <translation>阶跃 %1 之后的第一个值</translation>
    </message>
    <message>
        <source>an outlier</source>
        <translation>离群值</translation>
    </message>
    <message>
        <source>%1, %2 values, from %3 to %4: %5</source>
        <translation>%1，%2 个值，%3 至 %4：%5</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>基准阶段</translation>
    </message>
    <message>
        <source>value ± U (%1)</source>
        <translation>值 ± U (%1)</translation>
    </message>
    <message>
        <source>outside its limits</source>
        <translation>超出控制限</translation>
    </message>
    <message>
        <source>centre line</source>
        <translation>中心线</translation>
    </message>
    <message>
        <source>limits (3 u)</source>
        <translation>控制限 (3 u)</translation>
    </message>
    <message>
        <source>tolerance ± %1</source>
        <translation>允差 ± %1</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1 from the centre line, limits ± %2%3</source>
        <translation>距中心线 %1，控制限 ± %2%3</translation>
    </message>
    <message>
        <source>Should be: the values scatter about one level within their limits, and the average stays within its own.</source>
        <translation>应为：各值在控制限内围绕一个水平离散，平均保持在其自身的界限内。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportFiles</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>识别为</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>180° from line</source>
        <translation>180° 起始行</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Files to import</source>
        <translation>要导入的文件</translation>
    </message>
    <message>
        <source>180° from this line of “%1” on</source>
        <translation>“%1”从该行起为 180°</translation>
    </message>
    <message>
        <source>Position of “%1”</source>
        <translation>“%1”的轴位</translation>
    </message>
    <message>
        <source>Round of “%1”</source>
        <translation>“%1”的测回</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>按文件所述</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>请选择…</translation>
    </message>
    <message>
        <source>All at 0°</source>
        <translation>全部为 0°</translation>
    </message>
    <message>
        <source>All at 180°</source>
        <translation>全部为 180°</translation>
    </message>
    <message>
        <source>0°, then 180°</source>
        <translation>先 0°，后 180°</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportLayout</name>
    <message>
        <source>Columns of the file:</source>
        <translation>文件的列：</translation>
    </message>
    <message>
        <source>P&amp;osition:</source>
        <translation>轴位(&amp;O)：</translation>
    </message>
    <message>
        <source>&amp;Point:</source>
        <translation>测点(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Round:</source>
        <translation>测回(&amp;R)：</translation>
    </message>
    <message>
        <source>&amp;Face:</source>
        <translation>盘位(&amp;F)：</translation>
    </message>
    <message>
        <source>&amp;Horizontal:</source>
        <translation>水平(&amp;H)：</translation>
    </message>
    <message>
        <source>&amp;Vertical:</source>
        <translation>竖直(&amp;V)：</translation>
    </message>
    <message>
        <source>&amp;Slider:</source>
        <translation>滑块(&amp;S)：</translation>
    </message>
    <message>
        <source>E&amp;xcluded:</source>
        <translation>排除(&amp;X)：</translation>
    </message>
    <message>
        <source>&amp;Note:</source>
        <translation>备注(&amp;N)：</translation>
    </message>
    <message>
        <source>As written</source>
        <translation>按原样</translation>
    </message>
    <message>
        <source>Decimal degrees</source>
        <translation>十进制度</translation>
    </message>
    <message>
        <source>Gon</source>
        <translation>百分度 (gon)</translation>
    </message>
    <message>
        <source>Degrees.minutes seconds</source>
        <translation>度.分秒</translation>
    </message>
    <message>
        <source>Unit of the numbers in columns that state no unit. In degrees.minutes seconds, 341.5224 is 341°52′24″</source>
        <translation>用于列名未注明单位的纯数字。按度.分秒，341.5224 即 341°52′24″</translation>
    </message>
    <message>
        <source>Either</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>The last of these rows has the column names</source>
        <translation>其中最后一行为列名</translation>
    </message>
    <message>
        <source>&amp;Unit:</source>
        <translation>单位(&amp;U)：</translation>
    </message>
    <message>
        <source>&amp;Decimals:</source>
        <translation>小数(&amp;D)：</translation>
    </message>
    <message>
        <source>Rows &amp;before:</source>
        <translation>之前的行(&amp;B)：</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>Horizontal, &amp;2nd face:</source>
        <translation>水平度盘，盘右(&amp;2)：</translation>
    </message>
    <message>
        <source>Vertical, 2nd fa&amp;ce:</source>
        <translation>竖直度盘，盘右(&amp;C)：</translation>
    </message>
    <message>
        <source>columns %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>The settings below are those you last used for this layout.</source>
        <translation>以下为您上次导入此类格式时所用的设置。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportPage</name>
    <message>
        <source>Import readings</source>
        <translation>导入读数</translation>
    </message>
    <message>
        <source>Pointing zeros</source>
        <translation>瞄准零位</translation>
    </message>
    <message>
        <source>ZERO</source>
        <translation>ZERO</translation>
    </message>
    <message>
        <source>Na&amp;me in the files:</source>
        <translation>文件中的名称(&amp;M)：</translation>
    </message>
    <message>
        <source>Preview of the readings</source>
        <translation>导入后的读数</translation>
    </message>
    <message>
        <source>&amp;Add to the readings of this session</source>
        <translation>添加到本测量记录的读数(&amp;A)</translation>
    </message>
    <message>
        <source>Replace: begin a new session wi&amp;th them</source>
        <translation>替换：以其新建测量记录(&amp;T)</translation>
    </message>
    <message>
        <source>What cannot be used, and remarks</source>
        <translation>无法使用的内容与说明</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>Layout of “%1” and those like it</source>
        <translation>“%1”及同类文件的格式</translation>
    </message>
    <message>
        <source>Layout of “%1”</source>
        <translation>“%1”的格式</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>以及另外 %1 项。</translation>
    </message>
    <message>
        <source>“%1” was imported into this session before.</source>
        <translation>“%1”此前已导入本测量记录。</translation>
    </message>
    <message>
        <source>Choose the columns of the horizontal and the vertical circle of “%1”.</source>
        <translation>请选择“%1”的水平度盘列和竖直度盘列。</translation>
    </message>
    <message>
        <source>There are no readings besides the pointing zeros.</source>
        <translation>除瞄准零位外没有读数。</translation>
    </message>
    <message>
        <source>1 row of readings</source>
        <translation>1 行读数</translation>
    </message>
    <message>
        <source>%1 rows of readings</source>
        <translation>%1 行读数</translation>
    </message>
    <message>
        <source>; 1 entry or line cannot be used</source>
        <translation>；有 1 项或 1 行无法使用</translation>
    </message>
    <message>
        <source>; %1 entries or lines cannot be used</source>
        <translation>；有 %1 项或行无法使用</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>Sightings of the point with this name count as sightings of the pointing zero</source>
        <translation>照准此名称的点即照准瞄准零位</translation>
    </message>
    <message>
        <source>Pre&amp;view:</source>
        <translation>导入后的读数(&amp;W)：</translation>
    </message>
    <message>
        <source>“%1” does not state the unit of its angles: choose it.</source>
        <translation>请选择“%1”的角度单位：文件没有说明。</translation>
    </message>
    <message>
        <source>“%1” does not state the position it was read at: choose it.</source>
        <translation>请选择读取“%1”时的轴位：文件没有说明。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportPreview</name>
    <message>
        <source>?</source>
        <translation>？</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>Horizontal α</source>
        <translation>水平 α</translation>
    </message>
    <message>
        <source>Zenith β</source>
        <translation>天顶距 β</translation>
    </message>
    <message>
        <source>Elevation β</source>
        <translation>高度角 β</translation>
    </message>
    <message>
        <source>Slider s</source>
        <translation>滑块 s</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Tilt ⟂ ″</source>
        <translation>倾斜 ⟂ ″</translation>
    </message>
    <message>
        <source>Tilt ∥ ″</source>
        <translation>倾斜 ∥ ″</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>改正</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ImportZeros</name>
    <message>
        <source>Horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>&amp;Zero at %1:</source>
        <translation>%1 的零位(&amp;Z)：</translation>
    </message>
    <message>
        <source>Zero at %1:</source>
        <translation>%1 的零位：</translation>
    </message>
    <message>
        <source>Horizontal pointing zero at %1</source>
        <translation>%1 的水平瞄准零位</translation>
    </message>
    <message>
        <source>Vertical pointing zero at %1</source>
        <translation>%1 的竖直瞄准零位</translation>
    </message>
    <message>
        <source>type it now or later</source>
        <translation>请录入，或稍后再录</translation>
    </message>
    <message>
        <source>As in the files or the session</source>
        <translation>与文件或测量记录中相同</translation>
    </message>
    <message>
        <source>Pointing zero at %1: %2</source>
        <translation>%1 的瞄准零位：%2</translation>
    </message>
</context>
<context>
    <name>alidade::ui::InstallationDialog</name>
    <message>
        <source>Check of This Installation</source>
        <translation>本安装的检查</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>期望值</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>所得值</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最大允许</translation>
    </message>
    <message>
        <source>Lines of the check</source>
        <translation>检查的各行</translation>
    </message>
    <message>
        <source>Save as &amp;PDF…</source>
        <translation>存为 PDF(&amp;P)…</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>打印(&amp;R)…</translation>
    </message>
    <message>
        <source>Check &amp;Again</source>
        <translation>再次检查(&amp;A)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Save check of this installation</source>
        <translation>保存本安装的检查</translation>
    </message>
    <message>
        <source>Alidade cannot print on “%1”: choose another printer, or save a PDF.</source>
        <translation>打印机“%1”无法打印：请另选一台，或保存 PDF。</translation>
    </message>
    <message>
        <source>Print check of this installation</source>
        <translation>打印本安装的检查</translation>
    </message>
</context>
<context>
    <name>alidade::ui::InstrumentDesk</name>
    <message>
        <source>No port is chosen: choose the one that the cable is in.</source>
        <translation>未选择端口：请选择电缆所插的端口。</translation>
    </message>
    <message>
        <source>No baud rate is chosen: choose that of the instrument.</source>
        <translation>未选择波特率：请选择仪器的波特率。</translation>
    </message>
    <message>
        <source>Name the instrument</source>
        <translation>填写仪器</translation>
    </message>
    <message>
        <source>The session names an instrument with serial number %1, but the connected one has %2.</source>
        <translation>测量记录所填仪器的序列号为 %1，而所连接的仪器为 %2。</translation>
    </message>
    <message>
        <source>%1 readings wait until the open entry is accepted (Enter) or cancelled (Esc)</source>
        <translation>%1 个读数在等待：请提交（Enter）或取消（Esc）正在录入的输入项</translation>
    </message>
    <message>
        <source>The reading that came now was requested for another session and was not taken in: read again.</source>
        <translation>刚收到的读数是为另一测量记录请求的，未予录入：请重新读数。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::InstrumentDialog</name>
    <message>
        <source>Instrument Check</source>
        <translation>仪器检查</translation>
    </message>
    <message>
        <source>What the check says</source>
        <translation>检查的说明</translation>
    </message>
    <message>
        <source>Values over the rounds</source>
        <translation>各测回的变化</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Collimation over the distance</source>
        <translation>照准差随距离</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>图中所示内容</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>导出 JSON(&amp;J)…</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>导出 CSV(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Save as Instrument Record…</source>
        <translation>另存为仪器档案(&amp;S)…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Rounds to several targets in both faces show the scatter of a direction and of a zenith angle, and collimation, index and tilt of the trunnion axis. Allow half an hour, before a series and after a transport. Observe three rounds to four targets around the horizon, one of them steep, at distances like those of the work.</source>
        <translation>对多个目标的双盘位测回显示方向和天顶距的离散，以及照准差、指标差和横轴误差。在一系列测量之前和运输之后各用半小时。观测三个测回，四个分布于四周的目标，其中一个较陡，距离与工作时相近。</translation>
    </message>
    <message>
        <source>Export instrument check</source>
        <translation>导出仪器检查</translation>
    </message>
    <message>
        <source>Export residuals of the check</source>
        <translation>导出检查的残差</translation>
    </message>
    <message>
        <source>Save instrument record</source>
        <translation>保存仪器档案</translation>
    </message>
    <message>
        <source>Collimation, index, tilt, offset of the line of sight and σ of the circles, for use in sessions</source>
        <translation>照准差、指标差、横轴误差、视线偏距与度盘的 σ，供测量记录采用</translation>
    </message>
    <message>
        <source>Result by station</source>
        <translation>各测站的结果</translation>
    </message>
    <message>
        <source>Open files, or type rounds in two faces to several targets.</source>
        <translation>请打开文件，或录入对多个目标的双盘位测回。</translation>
    </message>
    <message>
        <source>&amp;PDF…</source>
        <translation>PDF(&amp;P)…</translation>
    </message>
    <message>
        <source>The check as a document</source>
        <translation>检查结果文档</translation>
    </message>
    <message>
        <source>The pages could not be painted.</source>
        <translation>无法绘制页面。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::InstrumentFlow</name>
    <message>
        <source>Take from the instrument record</source>
        <translation>取自仪器档案</translation>
    </message>
    <message>
        <source>“%1” cannot be used.

%2</source>
        <translation>“%1”无法使用。

%2</translation>
    </message>
    <message>
        <source>Taken from “%1”, known sizes: %2</source>
        <translation>已取自“%1”，已知值：%2</translation>
    </message>
    <message>
        <source>Save as instrument record</source>
        <translation>另存为仪器档案</translation>
    </message>
    <message>
        <source>The session&apos;s instrument data cannot be saved as a record.

%1</source>
        <translation>测量记录中关于其仪器的内容不能成为档案。

%1</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Saved “%1”</source>
        <translation>已保存“%1”</translation>
    </message>
    <message>
        <source>%1. Its next check was due on %2.</source>
        <translation>%1。其下次检查已于 %2 到期。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::InstrumentLink</name>
    <message>
        <source>The port %1 could not be opened: %2. Another program may be using it, or you are not in the group that may use ports (on Debian: dialout).</source>
        <translation>端口 %1 无法打开：%2。可能被另一程序占用，或您不属于可使用端口的组（在 Debian 上为 dialout）。</translation>
    </message>
    <message>
        <source>The port %1 could not be opened: %2. Is the cable plugged in, and is this the right port?</source>
        <translation>端口 %1 无法打开：%2。电缆是否插好，端口是否正确？</translation>
    </message>
    <message>
        <source>The connection was closed before the reading came: none was taken.</source>
        <translation>连接在读数到来之前关闭：没有取得读数。</translation>
    </message>
    <message>
        <source>No instrument is connected: connect it first (Instrument › Connect).</source>
        <translation>未连接仪器：请先连接（仪器 › 连接）。</translation>
    </message>
    <message>
        <source>The connection to the instrument broke: %1. Was the cable or the instrument unplugged? The readings are kept; plug it in and connect again.</source>
        <translation>到仪器的线路中断：%1。电缆或仪器是否被拔出？已读的保留不变；请插好后重新连接。</translation>
    </message>
    <message>
        <source>The instrument accepts no data: the send buffer is full, and sending has stopped. Check the cable and the instrument, then connect again.</source>
        <translation>仪器不接收数据：发送缓冲区已满，已停止发送。请检查电缆和仪器，然后重新连接。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::JobStatus</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops and keeps the result of the fit; the next edit restarts all calculations</source>
        <translation>停止计算并保留拟合结果；下次编辑会重新开始全部计算</translation>
    </message>
    <message>
        <source>Fitting…</source>
        <translation>正在拟合…</translation>
    </message>
    <message>
        <source>Diagnosing…</source>
        <translation>正在诊断…</translation>
    </message>
    <message>
        <source>Looking for misread readings…</source>
        <translation>正在查找误读…</translation>
    </message>
</context>
<context>
    <name>alidade::ui::JournalPanel</name>
    <message>
        <source>Journal of changes</source>
        <translation>更改日志</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>Universal time</source>
        <translation>世界时</translation>
    </message>
    <message>
        <source>What</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>Name of the entry at that time</source>
        <translation>该项当时的名称</translation>
    </message>
    <message>
        <source>180°, row 28 (point 28), vertical</source>
        <translation>180°，第 28 行（测点 28），竖直</translation>
    </message>
    <message>
        <source>From</source>
        <translation>由</translation>
    </message>
    <message>
        <source>Old content</source>
        <translation>原有内容</translation>
    </message>
    <message>
        <source>To</source>
        <translation>变为</translation>
    </message>
    <message>
        <source>New content</source>
        <translation>更改后的内容</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>suggestion accepted</source>
        <translation>采纳建议</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>操作者</translation>
    </message>
    <message>
        <source>Operator in the session at that time</source>
        <translation>测量记录当时记载的操作者</translation>
    </message>
    <message>
        <source>Checking the journal…</source>
        <translation>正在检查更改日志…</translation>
    </message>
    <message>
        <source>No entry was changed after it was recorded.</source>
        <translation>记录后没有任何条目被更改。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesModel</name>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>归属</translation>
    </message>
    <message>
        <source>Default u</source>
        <translation>默认 u</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
    <message>
        <source>Known from</source>
        <translation>已知来源</translation>
    </message>
    <message>
        <source>Catalogued effect, or one of its quantities</source>
        <translation>目录中的效应，或其某个量</translation>
    </message>
    <message>
        <source>Device or instrument to which the known size belongs</source>
        <translation>已知值归属于设备还是仪器</translation>
    </message>
    <message>
        <source>Plausible size (1σ), used if no size is known</source>
        <translation>合理大小（1σ），在没有已知值时采用</translation>
    </message>
    <message>
        <source>Known size, in the unit of the default; empty: 0</source>
        <translation>已知值，单位与默认值相同；空：0</translation>
    </message>
    <message>
        <source>Standard uncertainty of the known size, in the unit of the default; empty: the default</source>
        <translation>已知值的标准不确定度，单位与默认值相同；空：默认值</translation>
    </message>
    <message>
        <source>Certificate or check that gives the known size; named in the budget</source>
        <translation>给出已知值的证书或检查；不确定度预算中会列出</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Type the standard uncertainty of the known size; until then the default is used.</source>
        <translation>请输入已知值的标准不确定度；在此之前采用默认值。</translation>
    </message>
    <message>
        <source>The session has several known sizes for this quantity: their mean, weighted by 1/u², is used.</source>
        <translation>测量记录中对该量的已知值不止一处：采用以 1/u² 加权的平均值。</translation>
    </message>
    <message>
        <source>%1. Its known size belongs to the %2.</source>
        <translation>%1。有关它的已知值归属于%2。</translation>
    </message>
    <message>
        <source>%1 (again)</source>
        <translation>%1（再次）</translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesPanel</name>
    <message>
        <source>A size from a certificate or a check replaces the default in the uncertainty of Δd, measured, and in the search for causes.</source>
        <translation>证书或检查给出的量值取代默认值，用于实测 Δd 的不确定度和原因查找。</translation>
    </message>
    <message>
        <source>Take from Instrument Record…</source>
        <translation>取自仪器档案…</translation>
    </message>
    <message>
        <source>Name, serial number, σ of the circles and known sizes from a file</source>
        <translation>来自文件的名称、序列号、度盘的 σ 和已知值</translation>
    </message>
    <message>
        <source>Save as Instrument Record…</source>
        <translation>另存为仪器档案…</translation>
    </message>
    <message>
        <source>Saves the session&apos;s instrument data as a file for later sessions</source>
        <translation>将本测量记录的仪器数据存为文件，供以后的测量记录使用</translation>
    </message>
</context>
<context>
    <name>alidade::ui::KnownSizesTable</name>
    <message>
        <source>Known sizes of effects</source>
        <translation>各效应的已知值</translation>
    </message>
    <message>
        <source>Paste known sizes</source>
        <translation>粘贴已知值</translation>
    </message>
    <message>
        <source>Clear known sizes</source>
        <translation>清除已知值</translation>
    </message>
</context>
<context>
    <name>alidade::ui::LeftoverStrips</name>
    <message>
        <source>Leftover along s, e and t</source>
        <translation>沿 s、e 和 t 的剩余残差</translation>
    </message>
    <message>
        <source>%1 residuals of at most %2 σ</source>
        <translation>%1 个残差，最大 %2 σ</translation>
    </message>
    <message>
        <source>%1 circle: %2 σ</source>
        <translation>%1度盘：%2 σ</translation>
    </message>
    <message>
        <source>● horizontal  ◆ vertical; grey: the model holds</source>
        <translation>● 水平  ◆ 竖直；灰色：模型成立</translation>
    </message>
    <message>
        <source>● horizontal  ◆ vertical</source>
        <translation>● 水平  ◆ 竖直</translation>
    </message>
</context>
<context>
    <name>alidade::ui::LogoForm</name>
    <message>
        <source>Logo of the laboratory</source>
        <translation>实验室徽标</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Without</source>
        <translation>不用(&amp;W)</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.jpg *.jpeg *.bmp *.gif *.webp);;All files (*)</source>
        <translation>图片 (*.png *.svg *.jpg *.jpeg *.bmp *.gif *.webp);;所有文件 (*)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>alidade::ui::MainWindow</name>
    <message>
        <source>&amp;Measurement</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>I&amp;nstrument</source>
        <translation>仪器(&amp;N)</translation>
    </message>
    <message>
        <source>Se&amp;ssion</source>
        <translation>测量记录(&amp;S)</translation>
    </message>
    <message>
        <source>La&amp;boratory</source>
        <translation>实验室(&amp;B)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>不确定度预算</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>差距</translation>
    </message>
    <message>
        <source>Reliability</source>
        <translation>可靠性</translation>
    </message>
    <message>
        <source>Two Faces</source>
        <translation>双盘位</translation>
    </message>
    <message>
        <source>Known Sizes</source>
        <translation>已知值</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>更改日志</translation>
    </message>
    <message>
        <source>Open sample</source>
        <translation>打开示例</translation>
    </message>
    <message>
        <source>Something went wrong</source>
        <translation>出了问题</translation>
    </message>
    <message>
        <source>The search for misread readings was stopped.</source>
        <translation>已停止查找误读。</translation>
    </message>
    <message>
        <source>Forms of the session</source>
        <translation>测量记录表单</translation>
    </message>
    <message>
        <source>Positions of the axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Pages of the result</source>
        <translation>结果页</translation>
    </message>
    <message>
        <source>Pages of the details</source>
        <translation>详细页</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>%1 (sealed)</source>
        <translation>%1（已封存）</translation>
    </message>
    <message>
        <source>%1 (changed since the seal)</source>
        <translation>%1（封存后有更改）</translation>
    </message>
</context>
<context>
    <name>alidade::ui::OrderPanel</name>
    <message>
        <source>Sightings of the protocol</source>
        <translation>方案的照准</translation>
    </message>
    <message>
        <source>The session follows no protocol. Choose one by “Protocol”.</source>
        <translation>本次测量未采用方案。请用“方案”选择。</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Sightings taken</source>
        <translation>已有的照准</translation>
    </message>
    <message>
        <source>Expected reading</source>
        <translation>预期读数</translation>
    </message>
    <message>
        <source>Next sighting</source>
        <translation>下一次照准</translation>
    </message>
    <message>
        <source>Progress of the protocol</source>
        <translation>方案进度</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Position of the axis</source>
        <translation>轴的位置</translation>
    </message>
    <message>
        <source>Sighting</source>
        <translation>照准</translation>
    </message>
    <message>
        <source>Place with round and face, or pointing zero</source>
        <translation>位置、测回和盘位，或瞄准零位</translation>
    </message>
    <message>
        <source>pointing zero, face 2</source>
        <translation>瞄准零位，盘右</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Whether the sighting has been taken</source>
        <translation>是否已测</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Expected reading of the horizontal circle</source>
        <translation>水平度盘的预期读数</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>Expected reading of the vertical circle</source>
        <translation>竖直度盘的预期读数</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>Why the sighting must be taken again, or whether it was taken out of order</source>
        <translation>为何应重测，或是否未按顺序测</translation>
    </message>
    <message>
        <source>take again</source>
        <translation>重测</translation>
    </message>
    <message>
        <source>out of order</source>
        <translation>未按顺序</translation>
    </message>
    <message>
        <source>A protocol shows the next sighting and its expected reading, which sightings remain, which to repeat, and when the readings suffice.</source>
        <translation>方案给出下一次照准及其预期读数、剩余的照准、应重测的照准，以及读数何时足够。</translation>
    </message>
    <message>
        <source>sighting %1 of %2</source>
        <translation>第 %1 次照准，共 %2 次</translation>
    </message>
    <message>
        <source>The protocol is complete.</source>
        <translation>方案已全部测完。</translation>
    </message>
    <message>
        <source>Next at %1</source>
        <translation>下一次照准：%1</translation>
    </message>
    <message>
        <source>%1   %2</source>
        <translation>%1   %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>From the Rows</source>
        <translation>取自现有各行</translation>
    </message>
    <message>
        <source>From the Rows and %1</source>
        <translation>取自现有各行加%1</translation>
    </message>
    <message>
        <source>From the Rows and the Advice</source>
        <translation>取自现有各行加建议的读数</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>From a File…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>Save as a File…</source>
        <translation>存为文件…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Most Informative Next</source>
        <translation>下一步：信息最多者</translation>
    </message>
    <message>
        <source>The next sighting is the one with the most information per minute, not the first remaining one</source>
        <translation>下一次照准取单位时间信息最多者，而不是剩余的第一个</translation>
    </message>
    <message>
        <source>%1 of at most %2 taken</source>
        <translation>已照准 %1 次，至多 %2 次</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>方案：%1</translation>
    </message>
    <message>
        <source>The sightings needed for “U to reach” are listed here once L, R0 and a reading are entered (up to %1 rows).</source>
        <translation>填好 L、R0 和读数后（至多 %1 行），此处列出使 Δd 的 U 达到所需值的照准。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Lists the sightings that reach this U of Δd in the fewest minutes. Type 0 for a third of the tolerance</source>
        <translation>列出以最少分钟使 Δd 的 U 降到此值的照准。填 0 时取允差的三分之一</translation>
    </message>
    <message>
        <source>U to reach</source>
        <translation>须达到的 U</translation>
    </message>
    <message>
        <source>Enter the U of Δd to reach: the sightings that reach it soonest are listed here.</source>
        <translation>请输入须达到的 Δd 的 U：此处列出最快达到它的照准。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::OwnEffectCurve</name>
    <message>
        <source>Curve of the effect</source>
        <translation>效应的曲线</translation>
    </message>
    <message>
        <source>The curve appears once the formula is correct.</source>
        <translation>公式正确后显示曲线。</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>sighting of the session</source>
        <translation>测量记录中的照准</translation>
    </message>
</context>
<context>
    <name>alidade::ui::OwnEffectDialog</name>
    <message>
        <source>Opposite &amp;sign in face 2</source>
        <translation>盘右符号相反(&amp;S)</translation>
    </message>
    <message>
        <source>Effect of Your Own</source>
        <translation>自定义效应</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>no owner: for every session</source>
        <translation>无所属：适用于每份测量记录</translation>
    </message>
    <message>
        <source>device %1</source>
        <translation>设备 %1</translation>
    </message>
    <message>
        <source>instrument %1</source>
        <translation>仪器 %1</translation>
    </message>
    <message>
        <source>Save as &amp;File…</source>
        <translation>另存为文件(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Formula</source>
        <translation>公式(&amp;F)</translation>
    </message>
    <message>
        <source>Plausible sizes, 1σ</source>
        <translation>合理大小，1σ</translation>
    </message>
    <message>
        <source>&amp;Owner</source>
        <translation>所属(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Remedy</source>
        <translation>措施(&amp;R)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>an amplitude of a formula and its unit: A (mm)</extracomment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Trace of %1: %2 σ per %3, %4 σ at the plausible size.</source>
        <extracomment>%1: an amplitude; %3: a unit</extracomment>
        <translation>%1 的痕迹：每 %3 为 %2 σ，合理大小时为 %4 σ。</translation>
    </message>
    <message>
        <source>Save Effect</source>
        <translation>保存效应</translation>
    </message>
    <message>
        <source>Type a plausible size of %1, 1σ.</source>
        <extracomment>%1: an amplitude of a formula</extracomment>
        <translation>请输入 %1 的合理大小（1σ）。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::PaperForm</name>
    <message>
        <source>A4 (210 × 297 mm)</source>
        <translation>A4（210 × 297 mm）</translation>
    </message>
    <message>
        <source>Letter (216 × 279 mm)</source>
        <translation>Letter（216 × 279 mm）</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>纸张(&amp;P)</translation>
    </message>
    <message>
        <source>Le&amp;ft margin</source>
        <translation>左边距(&amp;F)</translation>
    </message>
    <message>
        <source>T&amp;op</source>
        <translation>上(&amp;O)</translation>
    </message>
    <message>
        <source>R&amp;ight</source>
        <translation>右(&amp;I)</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>下(&amp;M)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Page setup of the report</source>
        <translation>报告的页面设置</translation>
    </message>
    <message>
        <source>The report is printed in portrait format; wide margins make the print smaller.</source>
        <translation>报告按纵向打印；页边距大则印得较小。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::PlotWidget</name>
    <message>
        <source>Menu of the chart</source>
        <translation>图表菜单</translation>
    </message>
    <message>
        <source>Copy or save the chart, enlarge it, choose what is drawn (right click)</source>
        <translation>复制或保存图表、放大、选择绘制内容（右键单击）</translation>
    </message>
    <message>
        <source>Zoom &amp;In	+</source>
        <translation>放大(&amp;I)	+</translation>
    </message>
    <message>
        <source>Zoom &amp;Out	−</source>
        <translation>缩小(&amp;O)	−</translation>
    </message>
    <message>
        <source>Show &amp;Whole	Home</source>
        <translation>显示全部(&amp;W)	Home</translation>
    </message>
</context>
<context>
    <name>alidade::ui::PositionTabs</name>
    <message>
        <source>The session has no position with the axis at %1°.
Δd needs the arc at 0° and at 180°.</source>
        <translation>测量记录中没有 %1° 的轴位。
Δd 需要 0° 和 180° 的圆弧。</translation>
    </message>
    <message>
        <source>Add position at %1°</source>
        <translation>添加轴位 %1°</translation>
    </message>
    <message>
        <source>%1° missing</source>
        <translation>缺少 %1°</translation>
    </message>
    <message>
        <source>Axis at %1</source>
        <translation>轴位 %1</translation>
    </message>
    <message>
        <source>Alt+%1 goes to its readings</source>
        <translation>按 Alt+%1 转到其读数</translation>
    </message>
</context>
<context>
    <name>alidade::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>New &amp;Sessions</source>
        <translation>新测量记录(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Report</source>
        <translation>报告(&amp;R)</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>与桌面一致</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Another language applies when Alidade is started again.</source>
        <translation>更换的语言在重新启动 Alidade 后生效。</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>字体</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Tone for unexpected readings</source>
        <translation>意外读数提示音(&amp;T)</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>As the &amp;Desktop</source>
        <translation>与桌面一致(&amp;D)</translation>
    </message>
    <message>
        <source>%1, %2 pt</source>
        <translation>%1，%2 磅</translation>
    </message>
    <message>
        <source>New sessions start with these entries. Open sessions keep theirs.</source>
        <translation>新测量记录以这些内容开始；已打开的测量记录保持原样。</translation>
    </message>
    <message>
        <source>&amp;Load…</source>
        <translation>载入(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>无(&amp;N)</translation>
    </message>
    <message>
        <source>Protocol: %1, %2 sightings</source>
        <translation>方案：%1，%2 次照准</translation>
    </message>
    <message>
        <source>Protocol: none</source>
        <translation>方案：无</translation>
    </message>
    <message>
        <source>Like the window</source>
        <translation>与窗口相同</translation>
    </message>
    <message>
        <source>L&amp;anguage</source>
        <translation>语言(&amp;A)</translation>
    </message>
    <message>
        <source>The report is printed in portrait format; wide margins make the print smaller.</source>
        <translation>报告按纵向打印；页边距大则印得较小。</translation>
    </message>
    <message>
        <source>C&amp;hoose</source>
        <translation>选择(&amp;H)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::PrintPreview</name>
    <message>
        <source>Print preview</source>
        <translation>打印预览</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>打印…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Contents…</source>
        <translation>内容…</translation>
    </message>
    <message>
        <source>Page Setup…</source>
        <translation>页面设置…</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一页</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一页</translation>
    </message>
    <message>
        <source>Whole Page</source>
        <translation>整页</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>页宽</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ProtocolDialog</name>
    <message>
        <source>The s&amp;lider is read</source>
        <translation>读取滑块(&amp;L)</translation>
    </message>
    <message>
        <source>Pointing zero in &amp;both faces</source>
        <translation>瞄准零位用双盘位(&amp;B)</translation>
    </message>
    <message>
        <source>Pointing zero again &amp;after the readings</source>
        <translation>读数后再照准瞄准零位(&amp;A)</translation>
    </message>
    <message>
        <source>Edit Protocol</source>
        <translation>编辑方案</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>往返测</translation>
    </message>
    <message>
        <source>both, 1 then 2</source>
        <translation>双盘位，先盘左后盘右</translation>
    </message>
    <message>
        <source>both, 2 then 1</source>
        <translation>双盘位，先盘右后盘左</translation>
    </message>
    <message>
        <source>both, 1 2 2 1</source>
        <translation>双盘位，左右右左</translation>
    </message>
    <message>
        <source>changing from round to round</source>
        <translation>逐测回交替</translation>
    </message>
    <message>
        <source>0°, 180°</source>
        <translation>0°、180°</translation>
    </message>
    <message>
        <source>0°</source>
        <translation>0°</translation>
    </message>
    <message>
        <source>180°</source>
        <translation>180°</translation>
    </message>
    <message>
        <source>0°, 180°, 0° again</source>
        <translation>0°、180°、再测 0°</translation>
    </message>
    <message>
        <source>0°, 180°, both again</source>
        <translation>0°、180°、两者再测</translation>
    </message>
    <message>
        <source>slider coordinates, such as 10 20 30 …</source>
        <translation>滑块坐标，如 10 20 30 …</translation>
    </message>
    <message>
        <source>not turned</source>
        <translation>不转动</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Places</source>
        <translation>位置(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Rounds</source>
        <translation>测回(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Way</source>
        <translation>方向(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Faces</source>
        <translation>盘位(&amp;F)</translation>
    </message>
    <message>
        <source>Pos&amp;itions</source>
        <translation>轴位(&amp;I)</translation>
    </message>
    <message>
        <source>Circle &amp;turned between positions by</source>
        <translation>轴位之间度盘转动(&amp;T)</translation>
    </message>
    <message>
        <source>Type the places as angles with blanks between them: 10 20 30.5 40</source>
        <translation>请输入各位置的角度，以空格分隔：10 20 30.5 40</translation>
    </message>
    <message>
        <source>%1 sightings are too many for a protocol.</source>
        <translation>%1 次照准超出了一个方案允许的数量。</translation>
    </message>
    <message>
        <source>%1 sightings</source>
        <translation>%1 次照准</translation>
    </message>
    <message>
        <source>Entries restored as they were when the program ended.</source>
        <translation>各项已恢复为程序结束时的内容。</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Next: &amp;most informative</source>
        <translation>下一步取信息最多者(&amp;M)</translation>
    </message>
    <message>
        <source>Turning the a&amp;xis takes</source>
        <translation>转动轴需(&amp;X)</translation>
    </message>
    <message>
        <source>Pl&amp;unging the telescope takes</source>
        <translation>倒镜需(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Driving the slider takes</source>
        <translation>移动滑块需(&amp;D)</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>仅往测</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ProtocolFlow</name>
    <message>
        <source>Follow a protocol</source>
        <translation>按方案测量</translation>
    </message>
    <message>
        <source>The protocol “%1” cannot be followed.

%2</source>
        <translation>无法按方案“%1”测量。

%2</translation>
    </message>
    <message>
        <source>The session follows “%1”</source>
        <translation>本次测量按“%1”进行</translation>
    </message>
    <message>
        <source>Save as a measurement protocol</source>
        <translation>存为测量方案</translation>
    </message>
    <message>
        <source>The session follows no protocol.</source>
        <translation>本次测量未采用方案。</translation>
    </message>
    <message>
        <source>protocol</source>
        <translation>测量方案</translation>
    </message>
    <message>
        <source>Saved “%1”</source>
        <translation>已保存“%1”</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingFlow</name>
    <message>
        <source>The reading was rejected: %1 and %2, %3.</source>
        <translation>已不采用该读数：%1 和 %2，%3。</translation>
    </message>
    <message>
        <source>Readings that waited for the session before, and were not taken into this one: %1.</source>
        <translation>为前一测量记录等待、未录入本测量记录的读数：%1。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingQuestionBar</name>
    <message>
        <source>Take It</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Do Not Take It</source>
        <translation>不采用</translation>
    </message>
    <message>
        <source>Questionable reading of the instrument</source>
        <translation>有疑问的仪器读数</translation>
    </message>
    <message>
        <source>Enters the reading unchanged; the cell stays marked with the expected value</source>
        <translation>照所读填入；单元格保留标记，注明预期值</translation>
    </message>
    <message>
        <source>The reading stays in the connection log. Point at the right target and read again</source>
        <translation>该读数保留在连接日志中。请照准正确的目标后重读</translation>
    </message>
    <message>
        <source>%1 Further readings waiting: %2.</source>
        <translation>%1在其后等待的读数：%2。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingsFinder</name>
    <message>
        <source>Not found</source>
        <translation>未找到</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingsModel</name>
    <message>
        <source>Type here to add a reading</source>
        <translation>在此输入以添加读数</translation>
    </message>
    <message>
        <source>Looks misread: %1</source>
        <translation>像是误读：%1</translation>
    </message>
    <message>
        <source>First entered as %1</source>
        <translation>最初录入为 %1</translation>
    </message>
    <message>
        <source>Still to be read; until then the row is not used in the fit</source>
        <translation>尚待读取；在此之前该行不参与拟合</translation>
    </message>
    <message>
        <source>Excluded: kept, but not used in the fit</source>
        <translation>已排除：保留，但不参与拟合</translation>
    </message>
    <message>
        <source>As typed: %1</source>
        <translation>录入的内容：%1</translation>
    </message>
    <message>
        <source>No other reading checks this one: its residual cannot show an error</source>
        <translation>没有其他读数检核此读数：其残差不能反映误差</translation>
    </message>
    <message>
        <source>Standardised residual w = v/(s0 σ √r): %1</source>
        <translation>标准化残差 w = v/(s0 σ √r)：%1</translation>
    </message>
    <message>
        <source>Elevation β</source>
        <translation>高度角 β</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>used</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>%1: to be added</source>
        <translation>%1：待添加</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReadingsTable</name>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Columns of the clipboard that were not pasted: %1.</source>
        <translation>剪贴板中未粘贴的列：%1。</translation>
    </message>
    <message>
        <source>The last column of the clipboard did not fit and was not pasted.</source>
        <translation>剪贴板的最后一列没有位置，未粘贴。</translation>
    </message>
    <message>
        <source>The last %1 columns of the clipboard did not fit and were not pasted.</source>
        <translation>剪贴板的最后 %1 列没有位置，未粘贴。</translation>
    </message>
    <message>
        <source>The clipboard was not pasted: %1.</source>
        <translation>剪贴板内容未粘贴：%1。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReasonLine</name>
    <message>
        <source>Reason for the exclusion</source>
        <translation>排除的原因</translation>
    </message>
    <message>
        <source>Why is row %1 excluded? (Enter: no reason)</source>
        <translation>为何排除第 %1 行？（Enter：不说明）</translation>
    </message>
    <message>
        <source>Why are these %1 rows excluded? (Enter: no reason)</source>
        <translation>为何排除这 %1 行？（Enter：不说明）</translation>
    </message>
</context>
<context>
    <name>alidade::ui::RecordHistoryDialog</name>
    <message>
        <source>Instrument Records over Time</source>
        <translation>仪器档案随时间的变化</translation>
    </message>
    <message>
        <source>Records of the instrument</source>
        <translation>该仪器的档案</translation>
    </message>
    <message>
        <source>Add a folder of instrument records (*.alidade-instrument).</source>
        <translation>请添加存有仪器档案 (*.alidade-instrument) 的文件夹。</translation>
    </message>
    <message>
        <source>Save chart</source>
        <translation>保存图表</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Records in the baseline</source>
        <translation>基准阶段的档案数</translation>
    </message>
    <message>
        <source>all records</source>
        <translation>全部档案</translation>
    </message>
    <message>
        <source>The first records define centre line and limits for the later ones</source>
        <translation>前几份档案确定其后档案的中心线和控制限</translation>
    </message>
    <message>
        <source>&amp;Instrument</source>
        <translation>仪器(&amp;I)</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>添加文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>All instrument records (*.alidade-instrument) of a folder</source>
        <translation>一个文件夹中的全部仪器档案 (*.alidade-instrument)</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>导出 JSON(&amp;J)…</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>导出 CSV(&amp;C)…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Add a folder of instrument records</source>
        <translation>添加仪器档案文件夹</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>添加文件夹</translation>
    </message>
    <message>
        <source>%1 holds no other instrument record (*.alidade-instrument): choose another folder.</source>
        <translation>%1 中没有其他仪器档案 (*.alidade-instrument)：请选择另一个文件夹。</translation>
    </message>
    <message>
        <source>These records state no constant with its uncertainty.</source>
        <translation>这些档案没有给出带不确定度的常数。</translation>
    </message>
    <message>
        <source>%1 holds the same record as %2: counted once.</source>
        <translation>%1 与 %2 的档案相同：只计一次。</translation>
    </message>
    <message>
        <source>Export history</source>
        <translation>导出历史</translation>
    </message>
</context>
<context>
    <name>alidade::ui::RecoveryDialog</name>
    <message>
        <source>Unsaved changes were kept</source>
        <translation>已保留未保存的更改</translation>
    </message>
    <message>
        <source>Alidade ended without saving. Recover puts the changes back into the window, unsaved; the file stays as it is until you save.</source>
        <translation>Alidade 未保存就结束了。恢复后，更改将回到窗口中，仍未保存；在您保存之前文件保持不变。</translation>
    </message>
    <message>
        <source>Kept, unsaved</source>
        <translation>保留的（未保存）</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>文件中</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>以后(&amp;L)</translation>
    </message>
    <message>
        <source>Keeps the changes; File, Recover Unsaved Changes… offers them again</source>
        <translation>保留这些更改；“文件”菜单中的“恢复未保存的更改…”会再次提供</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>丢弃(&amp;D)…</translation>
    </message>
    <message>
        <source>Discard unsaved changes</source>
        <translation>丢弃未保存的更改</translation>
    </message>
    <message>
        <source>Once discarded, the changes of “%1” cannot be recovered.</source>
        <translation>“%1”的更改丢弃后将无法恢复。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::RecoveryKeeper</name>
    <message>
        <source>Unsaved changes would be lost in a crash: %1</source>
        <translation>未保存的更改在崩溃时会丢失：%1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReliabilityPanel</name>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>滑块</translation>
    </message>
    <message>
        <source>horizontal zero</source>
        <translation>水平零位</translation>
    </message>
    <message>
        <source>vertical zero</source>
        <translation>竖直零位</translation>
    </message>
    <message>
        <source>known radius</source>
        <translation>已知半径</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1 per mm</source>
        <translation>每 mm %1</translation>
    </message>
    <message>
        <source>%1 per ″</source>
        <translation>每 ″ %1</translation>
    </message>
    <message>
        <source>Reliability of every reading</source>
        <translation>每个读数的可靠性</translation>
    </message>
    <message>
        <source>No fit yet: the readings are listed here once they determine an arc.</source>
        <translation>尚无拟合：一旦读数确定圆弧，即列于此处。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Position of the axis</source>
        <translation>轴的位置</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation>滑块位置的编号</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Round of readings</source>
        <translation>读数的测回</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>Face of the theodolite</source>
        <translation>经纬仪的盘位</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>The reading; quantities entered once follow after all readings</source>
        <translation>读数；只录入一次的量列在所有读数之后</translation>
    </message>
    <message>
        <source>Residual ″</source>
        <translation>残差 ″</translation>
    </message>
    <message>
        <source>Observed − adjusted; right and up positive</source>
        <translation>观测值 − 平差值；向右、向上为正</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>Standardised residual v/(s0 σ √r): for correct readings, its standard deviation is 1</source>
        <translation>标准化残差 v/(s0 σ √r)：正常读数的标准偏差为 1</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation>多余观测分量</translation>
    </message>
    <message>
        <source>Share of an error that shows in the reading&apos;s own residual, 0 to 1; 0: no other reading checks it</source>
        <translation>误差显示在该读数自身残差中的份额，0 到 1；0：没有其他读数检核</translation>
    </message>
    <message>
        <source>Detectable ″</source>
        <translation>可检测 ″</translation>
    </message>
    <message>
        <source>Minimal detectable bias: the smallest error of this reading that the search for misread readings finds with a probability of 80 %; the risk of naming a correct reading anywhere in the session is 1 %; assumed noise: s0 σ</source>
        <translation>最小可检测偏差：查找误读时能以 80 % 的概率发现的该读数的最小误差；误指测量记录中任一正确读数的风险为 1 %；噪声取 s0 σ</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Moves Δd by mm</source>
        <translation>Δd 的改变 mm</translation>
    </message>
    <message>
        <source>Change of Δd by an undetected error of the size in “Detectable”; for quantities entered once, by an error of one unit</source>
        <translation>“可检测”一列大小的误差未被发现时引起的 Δd 的改变；对只录入一次的量，则为一个单位的误差引起的改变</translation>
    </message>
</context>
<context>
    <name>alidade::ui::RemedyList</name>
    <message>
        <source>The jump happened between a pointing zero and the first place after it, or that zero was misread; these readings do not show in which position. A jump cannot be added to the model: sight both zeros again and repeat the positions.</source>
        <translation>突跳发生在瞄准零位与其后第一个位置之间，或者是该零位被误读；这些读数不能说明是在哪个轴位。突跳不能加入模型：请重新照准两个零位并重新读取各轴位。</translation>
    </message>
    <message>
        <source>The jump happened before %1. A jump cannot be added to the model: check the tripod or pillar, sight the pointing zero again and repeat this position.</source>
        <translation>突跳发生在 %1 之前。突跳不能加入模型：请检查三脚架或观测墩，重新照准瞄准零位并再次读取该轴位。</translation>
    </message>
    <message>
        <source> Or leave out the rows before the jump, if the pointing zero of the next position was not sighted after the jump.</source>
        <translation>如果下一轴位的瞄准零位不是在突跳之后照准的，也可去掉突跳之前的行。</translation>
    </message>
    <message>
        <source> Or leave out the rows after the jump.</source>
        <translation>也可去掉突跳之后的行。</translation>
    </message>
    <message>
        <source> Or leave out the rows after the jump, if that zero was sighted after the jump.</source>
        <translation>如果该零位是在突跳之后照准的，也可去掉突跳之后的行。</translation>
    </message>
    <message>
        <source> Or leave out the rows after the jump, if the pointing zero of the next position was sighted after the jump.</source>
        <translation>如果下一轴位的瞄准零位是在突跳之后照准的，也可去掉突跳之后的行。</translation>
    </message>
    <message>
        <source>Set the relation to exact</source>
        <translation>将关系式设为精确</translation>
    </message>
    <message>
        <source>Set the relation to planar</source>
        <translation>将关系式设为平面</translation>
    </message>
    <message>
        <source>Sets “Relation” (vertical angle) in the Measurement form; this effect then need not be estimated</source>
        <translation>在测量表单中设置竖直角的“关系式”；此效应便不必再估计</translation>
    </message>
    <message>
        <source>The cause may also be %1, which would move Δd: read the position again before you exclude a row.</source>
        <translation>原因也可能是%1，它会使 Δd 改变：排除任何行之前请再次读取该轴位。</translation>
    </message>
    <message>
        <source> or </source>
        <translation>或</translation>
    </message>
    <message>
        <source>%1: off by %2</source>
        <extracomment>a reading and its error: 0°, point 11, horizontal: off by +29.0″</extracomment>
        <translation>%1：偏差 %2</translation>
    </message>
    <message>
        <source>Go to the reading</source>
        <translation>转到该读数</translation>
    </message>
    <message>
        <source>Exclude the row</source>
        <translation>排除该行</translation>
    </message>
    <message>
        <source>Exclude rows before the jump</source>
        <translation>排除突跳之前的行</translation>
    </message>
    <message>
        <source>Exclude rows after the jump</source>
        <translation>排除突跳之后的行</translation>
    </message>
    <message>
        <source>Nothing to add to the model: U already includes the scatter of the readings. If such scatter is usual for this instrument and site, state the larger σ.</source>
        <translation>没有可加入模型的内容：U 已包含读数的离散。如果对该仪器和场地而言这样的离散属于正常，请给定更大的 σ。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>State σ = %1</source>
        <translation>给定 σ = %1</translation>
    </message>
    <message>
        <source>Sets σ of the horizontal and the vertical circle in the Instrument form; σ of the pointing zero changes with them unless it was typed</source>
        <translation>在仪器表单中设置水平和竖直度盘的 σ；瞄准零位的 σ 若未录入则随之改变</translation>
    </message>
    <message>
        <source>Excludes the row from the fit; its entries are kept</source>
        <translation>将该行从拟合中去掉；录入的内容保留</translation>
    </message>
    <message>
        <source>Excludes the rows from the fit; their entries are kept</source>
        <translation>将这些行从拟合中去掉；录入的内容保留</translation>
    </message>
    <message>
        <source>Correct this sighting of the pointing zero, or clear it: the zero is the mean of the others.</source>
        <translation>请改正或清除瞄准零位的这次照准：零位取其余各次照准的平均值。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReportDialog</name>
    <message>
        <source>Acceptance report</source>
        <translation>验收报告</translation>
    </message>
    <message>
        <source>1 entry cannot be used. The report will list it and give no verdict.</source>
        <translation>有 1 个输入项无法使用。报告将列出它，且不作判定。</translation>
    </message>
    <message>
        <source>%1 entries cannot be used. The report will list them and give no verdict.</source>
        <translation>有 %1 个输入项无法使用。报告将列出它们，且不作判定。</translation>
    </message>
    <message>
        <source>Contents of the report</source>
        <translation>报告包含的内容</translation>
    </message>
    <message>
        <source>Always: result, U and verdict, findings, terms, excluded and changed readings, notes.</source>
        <translation>始终包含：结果、U 与判定、提示、术语、排除和更改的读数、备注。</translation>
    </message>
    <message>
        <source>%1 (model and readings disagree)</source>
        <translation>%1（模型与读数不符）</translation>
    </message>
    <message>
        <source>Session file and results, &amp;attached to the PDF</source>
        <translation>测量记录文件和结果，附于 PDF(&amp;A)</translation>
    </message>
    <message>
        <source>Alidade can open the session from the PDF again. The PDF then contains all readings.</source>
        <translation>Alidade 可从 PDF 中再次打开该测量记录。PDF 因此包含所有读数。</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>打印(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>Like the window</source>
        <translation>与窗口相同</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>History of the device</source>
        <translation>设备的历史</translation>
    </message>
    <message>
        <source>Choose &amp;folder…</source>
        <translation>选择文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>Folder of the sessions of this device: the report shows Δd over time on a separate page</source>
        <translation>此设备的测量记录所在的文件夹：报告用单独一页说明 Δd 随时间的变化</translation>
    </message>
    <message>
        <source>W&amp;ithout</source>
        <translation>不含(&amp;I)</translation>
    </message>
    <message>
        <source>Sessions of this device</source>
        <translation>此设备的测量记录</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>不包含</translation>
    </message>
    <message>
        <source>The session lacks entries that a laboratory&apos;s report should state: %1. The report marks them “not stated”; fill them in on the forms of the window.</source>
        <translation>测量记录缺少实验室报告应说明的内容：%1。报告将其标为“未说明”；可在窗口的表单中填写。</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>校准证书</translation>
    </message>
    <message>
        <source>ISO/IEC 17025 requires entries that the session lacks: %1. Fill them in on the forms of the window; without them only a draft can be made.</source>
        <translation>测量记录中未填写 ISO/IEC 17025 要求的内容：%1。可在窗口的表单中填写；否则只能出具草稿。</translation>
    </message>
    <message>
        <source>What the certificate states</source>
        <translation>证书说明的内容</translation>
    </message>
    <message>
        <source>Country of the laboratory: its two-letter code in ISO 3166-1</source>
        <translation>实验室所在国家：ISO 3166-1 的两字母代码</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>at the laboratory</source>
        <translation>在实验室</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>在客户处</translation>
    </message>
    <message>
        <source>at a branch of the laboratory</source>
        <translation>在实验室的分支机构</translation>
    </message>
    <message>
        <source>at a branch of the customer</source>
        <translation>在客户的分支机构</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>其他地点</translation>
    </message>
    <message>
        <source>&amp;Draft: say “not stated” for what is missing</source>
        <translation>草稿：缺少的内容注明“未说明”(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Country</source>
        <translation>国家(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Measured</source>
        <translation>测量地点(&amp;M)</translation>
    </message>
    <message>
        <source>Ma&amp;ker of the device</source>
        <translation>设备制造商(&amp;K)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ReportFlow</name>
    <message>
        <source>Export acceptance report</source>
        <translation>导出验收报告</translation>
    </message>
    <message>
        <source>Print acceptance report</source>
        <translation>打印验收报告</translation>
    </message>
    <message>
        <source>Print preview</source>
        <translation>打印预览</translation>
    </message>
    <message>
        <source>Acceptance report</source>
        <translation>验收报告</translation>
    </message>
    <message>
        <source>%1. Choose another logo in the dialog of the report, or none.</source>
        <translation>%1。请在报告对话框中另选徽标，或不用。</translation>
    </message>
    <message>
        <source>“%1” is a folder, pipe or device: choose a file.</source>
        <translation>“%1”是文件夹、管道或设备：请选择文件。</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>正在写入报告…</translation>
    </message>
    <message>
        <source>Stopped: no report was written.</source>
        <translation>已停止：没有写入报告。</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>报告已写入 %1</translation>
    </message>
    <message>
        <source>Printing the report…</source>
        <translation>正在打印报告…</translation>
    </message>
    <message>
        <source>Stopped: the report may be printed in part.</source>
        <translation>已停止：报告可能只打印了一部分。</translation>
    </message>
    <message>
        <source>Alidade cannot print on “%1”: choose another printer, or export a PDF.</source>
        <translation>无法在打印机“%1”上打印：请另选一台，或导出 PDF。</translation>
    </message>
    <message>
        <source>Report sent to the printer</source>
        <translation>报告已发送到打印机</translation>
    </message>
    <message>
        <source>Fitting and diagnosing for the report…</source>
        <translation>正在为报告拟合和诊断…</translation>
    </message>
    <message>
        <source>Reading the history of the device…</source>
        <translation>正在读取设备的历史…</translation>
    </message>
    <message>
        <source>The folder of the history holds no session of this device: the report has no history.</source>
        <translation>历史文件夹中没有此设备的测量记录：报告不含历史。</translation>
    </message>
    <message>
        <source>Export calibration certificate</source>
        <translation>导出校准证书</translation>
    </message>
    <message>
        <source>Writing the certificate…</source>
        <translation>正在写入证书…</translation>
    </message>
    <message>
        <source>Stopped: no certificate was written.</source>
        <translation>已停止：没有写入证书。</translation>
    </message>
    <message>
        <source>Certificate written to %1</source>
        <translation>证书已写入 %1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResidualChart</name>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Standardised</source>
        <translation>标准化(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Arcseconds</source>
        <translation>角秒(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Circles</source>
        <translation>度盘(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>水平(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>竖直(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Slider</source>
        <translation>滑块(&amp;S)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResidualPage</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>The range of the residuals shown. If it is empty, all residuals are shown</source>
        <translation>所显示残差的范围。留空则显示全部残差</translation>
    </message>
    <message>
        <source>Range of the residuals, ±</source>
        <translation>残差的范围 ±</translation>
    </message>
    <message>
        <source>Sho&amp;w ±</source>
        <translation>显示(&amp;W) ±</translation>
    </message>
    <message>
        <source>Over the slider coordinate s</source>
        <translation>按滑块坐标 s</translation>
    </message>
    <message>
        <source>In the order of reading</source>
        <translation>按读数顺序</translation>
    </message>
    <message>
        <source>Over the elevation e</source>
        <translation>按高度角 e</translation>
    </message>
    <message>
        <source>Over the azimuth a</source>
        <translation>按方位角 a</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>直方图</translation>
    </message>
    <message>
        <source>Normal Q–Q plot</source>
        <translation>正态 Q–Q 图</translation>
    </message>
    <message>
        <source>Kind of the chart</source>
        <translation>图的种类</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResidualPlot</name>
    <message>
        <source>row in the order read (time)</source>
        <translation>按读取顺序的行（时间）</translation>
    </message>
    <message>
        <source>elevation e (°), up positive</source>
        <translation>高度角 e (°)，向上为正</translation>
    </message>
    <message>
        <source>azimuth a (°), right positive</source>
        <translation>方位角 a (°)，向右为正</translation>
    </message>
    <message>
        <source>normal quantile</source>
        <translation>正态分位数</translation>
    </message>
    <message>
        <source>slider coordinate s (°): φ at 0°, −φ at 180°</source>
        <translation>滑块坐标 s (°)：0° 时为 φ，180° 时为 −φ</translation>
    </message>
    <message>
        <source>residual (″)</source>
        <translation>残差 (″)</translation>
    </message>
    <message>
        <source>No arc fitted yet: no residuals.</source>
        <translation>尚未拟合圆弧：没有残差。</translation>
    </message>
    <message>
        <source>There are no readings of the kind selected for the chart.</source>
        <translation>没有图中所选类型的读数。</translation>
    </message>
    <message>
        <source>not drawn: %1 without redundancy</source>
        <translation>未绘制：%1 个无多余观测的读数</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>正态</translation>
    </message>
    <message>
        <source>95 % band if normal</source>
        <translation>正态时的 95 % 范围</translation>
    </message>
    <message>
        <source>±1</source>
        <translation>±1</translation>
    </message>
    <message>
        <source>±3: 3 of 1000 lie beyond</source>
        <translation>±3：1000 个中有 3 个超出</translation>
    </message>
    <message>
        <source>±1σ, stated σ = %1</source>
        <translation>±1σ，给定的 σ = %1</translation>
    </message>
    <message>
        <source>±1σ %1, stated σ = %2</source>
        <translation>±1σ %1，给定的 σ = %2</translation>
    </message>
    <message>
        <source>±3σ</source>
        <translation>±3σ</translation>
    </message>
    <message>
        <source>slider: %1″</source>
        <translation>滑块：%1″</translation>
    </message>
    <message>
        <source>%1 circle: %2″</source>
        <translation>%1度盘：%2″</translation>
    </message>
    <message>
        <source>, row %1 in the order of reading</source>
        <translation>，按读取顺序第 %1 行</translation>
    </message>
    <message>
        <source> at e = %1°</source>
        <translation>，位于 e = %1°</translation>
    </message>
    <message>
        <source> at a = %1°</source>
        <translation>，位于 a = %1°</translation>
    </message>
    <message>
        <source> at s = %1°</source>
        <translation>，位于 s = %1°</translation>
    </message>
    <message>
        <source>, standardised w = %1</source>
        <translation>，标准化 w = %1</translation>
    </message>
    <message>
        <source>, normal quantile %1</source>
        <translation>，正态分位数 %1</translation>
    </message>
    <message>
        <source>Residuals of %1 readings, at most %2</source>
        <translation>%1 个读数的残差，最大 %2</translation>
    </message>
    <message>
        <source>Should be: the same even band from the first row to the last; no drift, no step between rounds.</source>
        <translation>应为：从第一行到最后一行为同样均匀的带；没有漂移，测回之间没有阶跃。</translation>
    </message>
    <message>
        <source>Should be: the marks follow the line inside the band; a reading outside the band at an end may be misread.</source>
        <translation>应为：各点在带内沿直线分布；在一端落到带外的读数可能是误读。</translation>
    </message>
    <message>
        <source>Should be: an even band about 0, two thirds within ±1, hardly any beyond ±3; no wave, no slope.</source>
        <translation>应为：围绕 0 的均匀带，三分之二在 ±1 之内，几乎没有超出 ±3 的；没有波动，没有倾斜。</translation>
    </message>
    <message>
        <source>Should be: an even band about 0, two thirds within ±1σ, hardly any beyond ±3σ; no wave, no slope.</source>
        <translation>应为：围绕 0 的均匀带，三分之二在 ±1σ 之内，几乎没有超出 ±3σ 的；没有波动，没有倾斜。</translation>
    </message>
    <message>
        <source>standardised w</source>
        <translation>标准化残差 w</translation>
    </message>
    <message>
        <source>number of residuals</source>
        <translation>残差个数</translation>
    </message>
    <message>
        <source>not drawn: %1 beyond ±%2</source>
        <extracomment>%1: number of residuals, %2: range, such as 10″</extracomment>
        <translation>未绘制：%1 个超出 ±%2</translation>
    </message>
    <message>
        <source>number in classes of %1</source>
        <translation>区间宽 %1 内的个数</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>one or several circles, and their σ</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>expected if normal, σ = 1</source>
        <translation>正态值的期望个数，σ = 1</translation>
    </message>
    <message>
        <source>expected for the stated σ = %1</source>
        <translation>按给定 σ = %1 的期望个数</translation>
    </message>
    <message>
        <source>class from %1 to %2: %3 residuals, expected %4</source>
        <translation>区间 %1 至 %2：残差 %3 个，期望 %4 个</translation>
    </message>
    <message>
        <source>Histogram of %1 residuals in classes %2 wide, at most %3 per class</source>
        <translation>%1 个残差的直方图，区间宽 %2，每区间至多 %3 个</translation>
    </message>
    <message>
        <source>Should be: the bars follow the curve. If they are wider, the stated σ is too small; two humps or a long tail show a gap or a misread reading.</source>
        <translation>应为：各柱沿曲线分布。若更宽，则给定的 σ 过小；双峰或长尾表明有差距或误读。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ResultPanel</name>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>&amp;Compare with published method</source>
        <translation>与已发表的方法比较(&amp;C)</translation>
    </message>
    <message>
        <source>0°</source>
        <translation>0°</translation>
    </message>
    <message>
        <source>180°</source>
        <translation>180°</translation>
    </message>
    <message>
        <source>|O1 − O2|/2  mm</source>
        <translation>|O1 − O2|/2  mm</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation>多余观测数</translation>
    </message>
    <message>
        <source>Some entries cannot be used. They are marked and listed with the reason.</source>
        <translation>有些输入项无法使用。它们已标出，并连同原因列出。</translation>
    </message>
    <message>
        <source>Δd needs both arcs: type the pointing zero and at least three readings at 0° and at 180°.</source>
        <translation>Δd 需要两个圆弧：请录入 0° 和 180° 的瞄准零位及至少三个读数。</translation>
    </message>
    <message>
        <source>Type the distance L, the nominal radius R0, the pointing zeros and at least three readings of the arc at 0° and at 180°.</source>
        <translation>请录入距离 L、标称半径 R0、瞄准零位，以及圆弧在 0° 和 180° 的至少三个读数。</translation>
    </message>
    <message>
        <source>No result</source>
        <translation>没有结果</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
</context>
<context>
    <name>alidade::ui::Safekeeping</name>
    <message>
        <source>not saved to a file yet</source>
        <translation>尚未存入文件</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>在 %1 中</translation>
    </message>
    <message>
        <source>which is no longer there</source>
        <translation>该文件已不存在</translation>
    </message>
    <message>
        <source>which cannot be read any more</source>
        <translation>该文件已无法读取</translation>
    </message>
    <message>
        <source>which has changed since Alidade last read or saved it</source>
        <translation>Alidade 上次读取或保存后，该文件已更改</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>%1; kept on %2</source>
        <translation>%1；保存于 %2</translation>
    </message>
    <message>
        <source>Unsaved changes in %1 cannot be read: %2</source>
        <translation>%1 中未保存的更改无法读取：%2</translation>
    </message>
    <message>
        <source>Recover unsaved changes</source>
        <translation>恢复未保存的更改</translation>
    </message>
    <message>
        <source>Recovered %1; not saved yet</source>
        <translation>已恢复 %1；尚未保存</translation>
    </message>
    <message>
        <source>Unsaved changes are not kept: save now</source>
        <translation>未保存的更改无法保留：请立即保存</translation>
    </message>
</context>
<context>
    <name>alidade::ui::SeriesWindow</name>
    <message>
        <source>Series — Alidade</source>
        <translation>系列 — Alidade</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史(&amp;H)</translation>
    </message>
    <message>
        <source>Save chart</source>
        <translation>保存图表</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>添加文件夹(&amp;F)…</translation>
    </message>
    <message>
        <source>All sessions (*.alidade) of a folder</source>
        <translation>文件夹中的所有测量记录 (*.alidade)</translation>
    </message>
    <message>
        <source>Add F&amp;iles…</source>
        <translation>添加文件(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Takes the selected sessions out of the series; their files stay</source>
        <translation>将所选测量记录移出系列；其文件保留</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>导出 JSON(&amp;J)…</translation>
    </message>
    <message>
        <source>The output of alidade-cli history --json</source>
        <translation>与 alidade-cli history --json 的输出相同</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>导出 CSV(&amp;C)…</translation>
    </message>
    <message>
        <source>The values of the quantity shown, with their limits</source>
        <translation>所示量的各值及其界限</translation>
    </message>
    <message>
        <source>&amp;PDF…</source>
        <translation>PDF(&amp;P)…</translation>
    </message>
    <message>
        <source>Exports the history of the device as a document</source>
        <translation>将设备的历史导出为文档</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Δd ± U</source>
        <translation>Δd ± U</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Sessions of the series</source>
        <translation>系列中的测量记录</translation>
    </message>
    <message>
        <source>Double click opens a session in the main window</source>
        <translation>双击可在主窗口中打开测量记录</translation>
    </message>
    <message>
        <source>Sessions read</source>
        <translation>已读取的测量记录</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Add a folder of sessions</source>
        <translation>添加测量记录文件夹</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>添加文件夹</translation>
    </message>
    <message>
        <source>%1 holds no session (*.alidade): choose another folder.</source>
        <translation>%1 中没有测量记录 (*.alidade)：请选择其他文件夹。</translation>
    </message>
    <message>
        <source>Reading and diagnosing sessions…</source>
        <translation>正在读取和诊断测量记录…</translation>
    </message>
    <message>
        <source>No sessions yet. Add a folder with the sessions of a device.</source>
        <translation>尚无测量记录。请添加一台设备的测量记录所在的文件夹。</translation>
    </message>
    <message>
        <source>Sessions: %1</source>
        <translation>测量记录：%1</translation>
    </message>
    <message>
        <source>Sessions: %1, of them not used: %2</source>
        <translation>测量记录：%1，其中未使用：%2</translation>
    </message>
    <message>
        <source>Export history</source>
        <translation>导出历史</translation>
    </message>
    <message>
        <source>Device history</source>
        <translation>设备历史</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>&amp;Shared Causes</source>
        <translation>共同原因(&amp;S)</translation>
    </message>
    <message>
        <source>Looking for causes that the sessions share…</source>
        <translation>正在查找各测量记录的共同原因…</translation>
    </message>
    <message>
        <source>Keep as an effect</source>
        <translation>存为效应</translation>
    </message>
    <message>
        <source>Single sessions, or a saved series</source>
        <translation>逐个添加测量记录，或已保存的系列</translation>
    </message>
    <message>
        <source>&amp;Save Series…</source>
        <translation>保存系列(&amp;S)…</translation>
    </message>
    <message>
        <source>Saves the list of these sessions and the baseline as a file that this window and alidade-cli can open</source>
        <translation>将这些测量记录的列表和基准阶段保存为文件，可在此处或由 alidade-cli 重新打开</translation>
    </message>
    <message>
        <source>Save series</source>
        <translation>保存系列</translation>
    </message>
    <message>
        <source>series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
</context>
<context>
    <name>alidade::ui::SessionDocument</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>alidade::ui::SimulationBox</name>
    <message>
        <source>Draws</source>
        <translation>抽样次数</translation>
    </message>
    <message>
        <source>Check by Monte Carlo</source>
        <translation>蒙特卡洛检验</translation>
    </message>
    <message>
        <source>as many as needed</source>
        <translation>按需要的次数</translation>
    </message>
    <message>
        <source>More draws determine the ends of the interval better. With 0, the number of draws is just enough to decide whether the propagated uncertainty is correct</source>
        <translation>抽样次数越多，区间端点越准。为 0 时，抽样次数恰好足以判断传播的不确定度是否正确</translation>
    </message>
    <message>
        <source>Draws every reading, pointing zero and length from its distribution and repeats the fit for each draw (JCGM 101)</source>
        <translation>每次从各读数、瞄准零位和长度的分布中抽样并重新拟合（JCGM 101）</translation>
    </message>
    <message>
        <source>Draws made</source>
        <translation>已完成的抽样</translation>
    </message>
    <message>
        <source>Stopped, because the session has changed.</source>
        <translation>测量记录已更改，因此停止。</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Too few of the draws gave a result.</source>
        <translation>有结果的抽样太少。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>The propagated uncertainty has not been checked yet.</source>
        <translation>传播的不确定度尚未检验。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::StartPage</name>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>更改时间</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>What it shows</source>
        <translation>内容说明</translation>
    </message>
    <message>
        <source>Alidade</source>
        <translation>Alidade</translation>
    </message>
    <message>
        <source>Does the centre of a rotatable arc lie on its axis? Enter the readings of a theodolite; get the intersection with its uncertainty and a verdict.</source>
        <translation>可转动圆弧的圆心是否在其轴上？输入经纬仪读数，得出相交度及其不确定度和判定。</translation>
    </message>
    <message>
        <source>New session</source>
        <translation>新建测量记录</translation>
    </message>
    <message>
        <source>Open a session or report…</source>
        <translation>打开测量记录或报告…</translation>
    </message>
    <message>
        <source>Import readings…</source>
        <translation>导入读数…</translation>
    </message>
    <message>
        <source>Guide: ten steps</source>
        <translation>指南：十步</translation>
    </message>
    <message>
        <source>Typing enters text in the session; Esc returns to the session; F1 opens the guide.</source>
        <translation>直接键入即在测量记录中录入；Esc 返回测量记录；F1 打开指南。</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>尚无文件</translation>
    </message>
</context>
<context>
    <name>alidade::ui::StatementView</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>alidade::ui::SuspectBar</name>
    <message>
        <source>Exclude row</source>
        <translation>排除该行</translation>
    </message>
    <message>
        <source>Readings that look misread</source>
        <translation>像是误读的读数</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Other possible readings</source>
        <translation>可能的其他读数</translation>
    </message>
    <message>
        <source>Keeps the row, but takes it out of the fit</source>
        <translation>保留该行，但不参与拟合</translation>
    </message>
    <message>
        <source>Next (F7)</source>
        <translation>下一个 (F7)</translation>
    </message>
    <message>
        <source>Goes to the reading in the table; pressed again, to the next</source>
        <translation>转到表格中的该读数；再次点击则转到下一个</translation>
    </message>
    <message>
        <source>Looking for misread readings…</source>
        <translation>正在查找误读…</translation>
    </message>
    <message>
        <source>Use %1 (F8)</source>
        <translation>采用 %1 (F8)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>第 %1 个，共 %2 个</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Correct point %1</source>
        <translation>改正测点 %1</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ToleranceBar</name>
    <message>
        <source>Result on the scale of the tolerance</source>
        <translation>结果在允差标尺上的位置</translation>
    </message>
    <message>
        <source>%1, from %2 to %3 with its uncertainty; the limit is %4.</source>
        <translation>%1，计入不确定度为 %2 至 %3；限值为 %4。</translation>
    </message>
</context>
<context>
    <name>alidade::ui::TrialList</name>
    <message>
        <source>Score so far</source>
        <translation>目前得分</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>盲测</translation>
    </message>
    <message>
        <source>Number of the trial</source>
        <translation>盲测的编号</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>读数计划</translation>
    </message>
    <message>
        <source>Plan of readings</source>
        <translation>读数计划</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>真实情况</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>所模拟的内容</translation>
    </message>
    <message>
        <source>vertical circle eccentricity</source>
        <translation>竖直度盘偏心</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>密封</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Whether the diagnosis was right</source>
        <translation>诊断是否正确</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>Trials drawn</source>
        <translation>已抽取的盲测</translation>
    </message>
    <message>
        <source>Every trial is listed here as it is drawn.</source>
        <translation>每个盲测抽取后即列于此处。</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>false alarms</source>
        <translation>误报</translation>
    </message>
    <message>
        <source>Δd ± U covers the truth</source>
        <translation>Δd ± U 覆盖真值</translation>
    </message>
    <message>
        <source>No seal was opened yet</source>
        <translation>尚未启封</translation>
    </message>
    <message>
        <source>still sealed: %1</source>
        <translation>仍密封：%1</translation>
    </message>
    <message>
        <source>%1: %2 of %3 (%4 %)</source>
        <translation>%1：%3 个中 %2 个（%4 %）</translation>
    </message>
</context>
<context>
    <name>alidade::ui::TwoFacesPanel</name>
    <message>
        <source>Two-face table</source>
        <translation>双盘位表</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Position of the axis</source>
        <translation>轴的位置</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Number of the slider&apos;s place</source>
        <translation>滑块位置的编号</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Round of readings</source>
        <translation>读数的测回</translation>
    </message>
    <message>
        <source>Elevation °</source>
        <translation>高度角 °</translation>
    </message>
    <message>
        <source>Elevation above the pointing zero, mean of both faces</source>
        <translation>高于瞄准零位的高度角，两盘位平均</translation>
    </message>
    <message>
        <source>2c ″</source>
        <translation>2c ″</translation>
    </message>
    <message>
        <source>α1 − (α2 ± 180°) = 2(c/cos e + i·tan e); c: collimation, i: trunnion tilt</source>
        <translation>α1 − (α2 ± 180°) = 2(c/cos e + i·tan e)；c：照准差，i：横轴误差</translation>
    </message>
    <message>
        <source>2c residual ″</source>
        <translation>2c 残差 ″</translation>
    </message>
    <message>
        <source>2c from the readings minus 2c from the fitted collimation and trunnion tilt</source>
        <translation>所读的 2c 减去由拟合的照准差和横轴误差算得的 2c</translation>
    </message>
    <message>
        <source>Index ″</source>
        <translation>指标差 ″</translation>
    </message>
    <message>
        <source>Index error of the vertical circle: half of the difference β1 + β2 − nominal sum</source>
        <translation>竖直度盘的指标差：（β1 + β2 − 标称和）的一半</translation>
    </message>
</context>
<context>
    <name>alidade::ui::WindowActions</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>打开最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Import Readings…</source>
        <translation>导入读数(&amp;I)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>Import from Clip&amp;board…</source>
        <translation>从剪贴板导入(&amp;B)…</translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Changes…</source>
        <translation>恢复未保存的更改(&amp;V)…</translation>
    </message>
    <message>
        <source>There are no unsaved changes to recover</source>
        <translation>没有可恢复的未保存更改</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Rever&amp;t</source>
        <translation>还原(&amp;T)</translation>
    </message>
    <message>
        <source>Sea&amp;l…</source>
        <translation>封存(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Export Acceptance Report…</source>
        <translation>导出验收报告(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>打印预览(&amp;W)…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Readings (CSV)…</source>
        <translation>读数 (CSV)(&amp;R)…</translation>
    </message>
    <message>
        <source>Re&amp;siduals (CSV)…</source>
        <translation>残差 (CSV)(&amp;S)…</translation>
    </message>
    <message>
        <source>R&amp;esult (JSON)…</source>
        <translation>结果 (JSON)(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Gap (JSON)…</source>
        <translation>差距 (JSON)(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;Budget (CSV)…</source>
        <translation>不确定度预算 (CSV)(&amp;B)…</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>尚无文件</translation>
    </message>
    <message>
        <source>&amp;Clear This List</source>
        <translation>清除此列表(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销：%1(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做：%1(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Paste as Readings…</source>
        <translation>粘贴为读数…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>查找(&amp;F)…</translation>
    </message>
    <message>
        <source>Find Next</source>
        <translation>查找下一个</translation>
    </message>
    <message>
        <source>Find Previous</source>
        <translation>查找上一个</translation>
    </message>
    <message>
        <source>&amp;Insert Reading Above</source>
        <translation>在上方插入读数(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>&amp;Delete Readings</source>
        <translation>删除读数(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+-</source>
        <translation>Ctrl+-</translation>
    </message>
    <message>
        <source>E&amp;xclude or Use	Space</source>
        <translation>排除或使用(&amp;X)	Space</translation>
    </message>
    <message>
        <source>C&amp;lear Cells	Del</source>
        <translation>清除单元格(&amp;L)	Del</translation>
    </message>
    <message>
        <source>Exclude or use the selected readings (Space)</source>
        <translation>排除或使用所选读数 (Space)</translation>
    </message>
    <message>
        <source>&amp;Next Misread Reading</source>
        <translation>下一个误读读数(&amp;N)</translation>
    </message>
    <message>
        <source>Use Proposed Readin&amp;g</source>
        <translation>采用建议的读数(&amp;G)</translation>
    </message>
    <message>
        <source>Add Ro&amp;ws</source>
        <translation>添加行(&amp;W)</translation>
    </message>
    <message>
        <source>Another &amp;Round</source>
        <translation>再一测回(&amp;R)</translation>
    </message>
    <message>
        <source>To Next Entr&amp;y</source>
        <translation>转到下一输入项(&amp;Y)</translation>
    </message>
    <message>
        <source>Alt+0</source>
        <translation>Alt+0</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>Readings at %1°</source>
        <translation>%1° 的读数</translation>
    </message>
    <message>
        <source>Measure %1° Again</source>
        <translation>复测 %1°</translation>
    </message>
    <message>
        <source>Add Position at %1°</source>
        <translation>添加轴位 %1°</translation>
    </message>
    <message>
        <source>Delete Position</source>
        <translation>删除轴位</translation>
    </message>
    <message>
        <source>Delete Position %1</source>
        <translation>删除轴位 %1</translation>
    </message>
    <message>
        <source>Move Readings to %1</source>
        <translation>将读数移到 %1</translation>
    </message>
    <message>
        <source>Move Readings</source>
        <translation>移动读数</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>A column that the session uses is always shown</source>
        <translation>测量记录使用的列始终显示</translation>
    </message>
    <message>
        <source>A&amp;ngles in</source>
        <translation>角度单位(&amp;N)</translation>
    </message>
    <message>
        <source>Degrees, &amp;Minutes, Seconds</source>
        <translation>度分秒(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Decimal Degrees</source>
        <translation>十进制度(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Gon</source>
        <translation>百分度 gon(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Enlarge Lower Pages</source>
        <translation>放大下方页面(&amp;E)</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Enlarge the lower pages over the picture, or reduce them again (Ctrl+0)</source>
        <translation>将下方页面放大至覆盖图形，或恢复 (Ctrl+0)</translation>
    </message>
    <message>
        <source>Enlarge lower pages</source>
        <translation>放大下方页面</translation>
    </message>
    <message>
        <source>T&amp;ools</source>
        <translation>工具(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Blind Trial…</source>
        <translation>盲测(&amp;B)…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>命令(&amp;C)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>指南(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;First Measurement</source>
        <translation>第一次测量(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Keys of the Table</source>
        <translation>表格按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation>起始页(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;About Alidade</source>
        <translation>关于 Alidade(&amp;A)</translation>
    </message>
    <message>
        <source>Large D&amp;isplay</source>
        <translation>大字显示(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>&amp;Instrument Check…</source>
        <translation>仪器检查(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Series…</source>
        <translation>系列(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>连接(&amp;C)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>&amp;Take Reading</source>
        <translation>读取读数(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Calibration Certificate (DCC)…</source>
        <translation>校准证书 (DCC)(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Check This Installation…</source>
        <translation>检查本安装(&amp;C)…</translation>
    </message>
    <message>
        <source>New &amp;from This Session</source>
        <translation>以本测量记录新建(&amp;F)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Pr&amp;eferences…</source>
        <translation>首选项(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Larger Font</source>
        <translation>放大字体(&amp;L)</translation>
    </message>
    <message>
        <source>S&amp;maller Font</source>
        <translation>缩小字体(&amp;M)</translation>
    </message>
    <message>
        <source>State Reason for C&amp;hange</source>
        <translation>说明更改的原因(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Instr&amp;ument</source>
        <translation>仪器(&amp;U)</translation>
    </message>
    <message>
        <source>Instrument &amp;Records…</source>
        <translation>仪器档案(&amp;R)…</translation>
    </message>
    <message>
        <source>Re&amp;turn Run</source>
        <translation>返测(&amp;T)</translation>
    </message>
    <message>
        <source>Return Run in Other &amp;Face</source>
        <translation>另一盘位返测(&amp;F)</translation>
    </message>
</context>
<context>
    <name>alidade::ui::WireLog</name>
    <message>
        <source>Log of the connection</source>
        <translation>连接日志</translation>
    </message>
</context>
<context>
    <name>alidade::ui::ZeroEntries</name>
    <message>
        <source>required</source>
        <translation>必填</translation>
    </message>
    <message>
        <source>Pointing zero, horizontal</source>
        <translation>瞄准零位，水平</translation>
    </message>
    <message>
        <source>Horizontal circle reading of the direction perpendicular to the plane of the arc, in face 1 before the readings of this position</source>
        <translation>垂直于圆弧平面方向的水平度盘读数，盘左，在该轴位读数之前</translation>
    </message>
    <message>
        <source>&amp;α0</source>
        <translation>&amp;α0</translation>
    </message>
    <message>
        <source>Pointing zero, vertical</source>
        <translation>瞄准零位，竖直</translation>
    </message>
    <message>
        <source>Vertical circle reading of the direction perpendicular to the plane of the arc, in face 1 before the readings of this position</source>
        <translation>垂直于圆弧平面方向的竖直度盘读数，盘左，在该轴位读数之前</translation>
    </message>
    <message>
        <source>&amp;β0</source>
        <translation>&amp;β0</translation>
    </message>
    <message>
        <source>Position of the axis in degrees</source>
        <translation>轴的位置，单位度</translation>
    </message>
    <message>
        <source>Rotation of the axis: 0 or 180 degrees</source>
        <translation>轴的转角：0 或 180 度</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>轴位(&amp;X)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Further sightings of the pointing zero: in face 2, and after the readings</source>
        <translation>瞄准零位的其他照准：盘右，以及读数之后</translation>
    </message>
    <message>
        <source>Further sightings of the pointing zero</source>
        <translation>瞄准零位的其他照准</translation>
    </message>
    <message>
        <source>Face 2</source>
        <translation>盘右</translation>
    </message>
    <message>
        <source>in face 2 before the readings of this position</source>
        <translation>盘右，在该轴位读数之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>in face 1 after the readings of this position</source>
        <translation>盘左，在该轴位读数之后</translation>
    </message>
    <message>
        <source>After, face 2</source>
        <translation>之后，盘右</translation>
    </message>
    <message>
        <source>in face 2 after the readings of this position</source>
        <translation>盘右，在该轴位读数之后</translation>
    </message>
    <message>
        <source>Pointing zero, horizontal, %1</source>
        <translation>瞄准零位，水平，%1</translation>
    </message>
    <message>
        <source>Horizontal circle reading of the pointing zero %1</source>
        <translation>瞄准零位的水平度盘读数，%1</translation>
    </message>
    <message>
        <source>Pointing zero, vertical, %1</source>
        <translation>瞄准零位，竖直，%1</translation>
    </message>
    <message>
        <source>Vertical circle reading of the pointing zero %1</source>
        <translation>瞄准零位的竖直度盘读数，%1</translation>
    </message>
</context>
</TS>
